<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>FindDialog</name>
    <message>
        <source>Components</source>
        <translation>Komponenten</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signale</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Aufzeichnungen</translation>
    </message>
    <message>
        <source>What was tried</source>
        <translation>Was geprüft wurde</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Läufe</translation>
    </message>
    <message>
        <source>Text of the models</source>
        <translation>Text der Modelle</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>anpassen</translation>
    </message>
    <message>
        <source>validate</source>
        <translation>validieren</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, Zeile %2</translation>
    </message>
    <message>
        <source>Find in the study</source>
        <translation>In der Studie suchen</translation>
    </message>
    <message>
        <source>Component, parameter, signal, recording, effect, run, text</source>
        <translation>Komponente, Parameter, Signal, Aufzeichnung, Effekt, Lauf, Text</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Was gefunden wurde</translation>
    </message>
    <message>
        <source>Nothing of the study is called so.</source>
        <translation>Nichts in der Studie heißt so.</translation>
    </message>
    <message>
        <source>%1 found. Enter goes there, Esc closes.</source>
        <translation>%1 gefunden. Eingabe führt hin, Esc schließt.</translation>
    </message>
</context>
<context>
    <name>ReportDialog</name>
    <message>
        <source>Errors of each recording</source>
        <translation>Fehler jeder Aufzeichnung</translation>
    </message>
    <message>
        <source>Effects with their evidence</source>
        <translation>Effekte mit ihren Belegen</translation>
    </message>
    <message>
        <source>Diagram before and after</source>
        <translation>Diagramm vorher und nachher</translation>
    </message>
    <message>
        <source>What is unexplained</source>
        <translation>Was nicht erklärt ist</translation>
    </message>
    <message>
        <source>Measured and simulated</source>
        <translation>Gemessen und simuliert</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>What is left</source>
        <translation>Was übrig bleibt</translation>
    </message>
    <message>
        <source>What was tried</source>
        <translation>Was geprüft wurde</translation>
    </message>
    <message>
        <source>Warnings and remarks</source>
        <translation>Warnungen und Bemerkungen</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Write report …</source>
        <translation>Bericht schreiben …</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Preview of the head</source>
        <translation>Vorschau des Kopfes</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Keep the head in the study without writing a report</source>
        <translation>Den Kopf in der Studie behalten, ohne einen Bericht zu schreiben</translation>
    </message>
    <message>
        <source>There is no result yet.</source>
        <translation>Es gibt noch kein Ergebnis.</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>Heute</translation>
    </message>
    <message>
        <source>Today's date</source>
        <translation>Datum von heute</translation>
    </message>
    <message>
        <source>Choose a picture: PNG, JPEG or SVG</source>
        <translation>Ein Bild wählen: PNG, JPEG oder SVG</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Test object</source>
        <translation>Exemplar</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>Verfasser</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Logo</source>
        <translation>Logo</translation>
    </message>
    <message>
        <source>PNG, JPEG or SVG; it is kept with the study</source>
        <translation>PNG, JPEG oder SVG; es wird bei der Studie aufbewahrt</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Abschnitte</translation>
    </message>
    <message>
        <source>Choose a logo</source>
        <translation>Logo wählen</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.svg)</source>
        <translation>Bilder (*.png *.jpg *.jpeg *.svg)</translation>
    </message>
    <message>
        <source>Logo: %1</source>
        <translation>Logo: %1</translation>
    </message>
    <message>
        <source>Head of the report</source>
        <translation>Kopf des Berichts</translation>
    </message>
</context>
<context>
    <name>BlockItem</name>
    <message>
        <source>This class is not known.</source>
        <translation>Diese Klasse ist nicht bekannt.</translation>
    </message>
</context>
<context>
    <name>ChannelBrowser</name>
    <message>
        <source>Tick what is shown</source>
        <translation>Gezeigte anhaken</translation>
    </message>
    <message>
        <source>Search by name, unit or comment</source>
        <translation>Nach Name, Einheit oder Kommentar suchen</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Kommentar</translation>
    </message>
    <message>
        <source>Channels of the file</source>
        <translation>Kanäle der Datei</translation>
    </message>
    <message>
        <source>A channel that is marked is drawn here.</source>
        <translation>Ein markierter Kanal wird hier gezeichnet.</translation>
    </message>
    <message>
        <source>Read 1 channel</source>
        <translation>1 Kanal lesen</translation>
    </message>
    <message>
        <source>Read %1 channels</source>
        <translation>%1 Kanäle lesen</translation>
    </message>
    <message>
        <source>%1 samples, %2</source>
        <translation>%1 Werte, %2</translation>
    </message>
    <message>
        <source>over time</source>
        <translation>über der Zeit</translation>
    </message>
    <message>
        <source>over an angle</source>
        <translation>über einem Winkel</translation>
    </message>
    <message>
        <source>over a distance</source>
        <translation>über einem Weg</translation>
    </message>
    <message>
        <source>counted</source>
        <translation>gezählt</translation>
    </message>
    <message>
        <source>states</source>
        <translation>Zustände</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lesen</translation>
    </message>
</context>
<context>
    <name>ComparePage</name>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Bezug</translation>
    </message>
    <message>
        <source>The recording whose stamps are taken for right</source>
        <translation>Die Messung, deren Zeitstempel als richtig gelten</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>Shift in s</source>
        <translation>Verschiebung in s</translation>
    </message>
    <message>
        <source>How sure</source>
        <translation>Wie sicher</translation>
    </message>
    <message>
        <source>Clock now</source>
        <translation>Uhr jetzt</translation>
    </message>
    <message>
        <source>How much later than the reference it stamps; it can be typed</source>
        <translation>Um wie viel später als der Bezug sie stempelt; es kann eingetippt werden</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>Reading …</source>
        <translation>Lesen …</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>%1 in several recordings</source>
        <translation>%1 in mehreren Messungen</translation>
    </message>
    <message>
        <source>Only one recording has %1: import another one and map it.</source>
        <translation>Nur eine Messung hat %1: Importieren Sie eine weitere und ordnen Sie sie zu.</translation>
    </message>
    <message>
        <source>Each is drawn earlier by its shift: where it is right they lie on each other.</source>
        <translation>Jede ist um ihre Verschiebung früher gezeichnet: Wo sie stimmt, liegen sie aufeinander.</translation>
    </message>
    <message>
        <source>the reference</source>
        <translation>der Bezug</translation>
    </message>
    <message>
        <source>± %1 s, correlation %2</source>
        <translation>± %1 s, Korrelation %2</translation>
    </message>
    <message>
        <source>Set as its clock</source>
        <translation>Als ihre Uhr setzen</translation>
    </message>
    <message>
        <source>Set the clock of %1</source>
        <translation>Uhr von %1 stellen</translation>
    </message>
</context>
<context>
    <name>ComposeActions</name>
    <message>
        <source>a new output of the model</source>
        <translation>ein neuer Ausgang des Modells</translation>
    </message>
    <message>
        <source>a new input of the model</source>
        <translation>ein neuer Eingang des Modells</translation>
    </message>
    <message>
        <source>Group into a model …</source>
        <translation>Zu einem Modell zusammenfassen …</translation>
    </message>
    <message>
        <source>Open its diagram</source>
        <translation>Sein Diagramm öffnen</translation>
    </message>
    <message>
        <source>Back to the model around it</source>
        <translation>Zurück zum umgebenden Modell</translation>
    </message>
    <message>
        <source>Name of the new model</source>
        <translation>Name des neuen Modells</translation>
    </message>
    <message>
        <source>Insert block …</source>
        <translation>Block einsetzen …</translation>
    </message>
    <message>
        <source>Connect …</source>
        <translation>Verbinden …</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Ausschneiden</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Rename …</source>
        <translation>Umbenennen …</translation>
    </message>
    <message>
        <source>Rename model …</source>
        <translation>Modell umbenennen …</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Alles auswählen</translation>
    </message>
    <message>
        <source>Align left</source>
        <translation>Links ausrichten</translation>
    </message>
    <message>
        <source>Align right</source>
        <translation>Rechts ausrichten</translation>
    </message>
    <message>
        <source>Align top</source>
        <translation>Oben ausrichten</translation>
    </message>
    <message>
        <source>Align bottom</source>
        <translation>Unten ausrichten</translation>
    </message>
    <message>
        <source>Align in a row</source>
        <translation>In einer Reihe ausrichten</translation>
    </message>
    <message>
        <source>Align in a column</source>
        <translation>In einer Spalte ausrichten</translation>
    </message>
    <message>
        <source>Insert a block: type its name</source>
        <translation>Block einsetzen: Namen eingeben</translation>
    </message>
    <message>
        <source>This block has no connector.</source>
        <translation>Dieser Block hat keinen Anschluss.</translation>
    </message>
    <message>
        <source>Connect from</source>
        <translation>Verbinden von</translation>
    </message>
    <message>
        <source>No connector of the diagram fits %1.</source>
        <translation>Kein Anschluss des Diagramms passt zu %1.</translation>
    </message>
    <message>
        <source>Connect %1 with</source>
        <translation>%1 verbinden mit</translation>
    </message>
    <message>
        <source>New name of %1</source>
        <translation>Neuer Name von %1</translation>
    </message>
    <message>
        <source>New name of the model</source>
        <translation>Neuer Name des Modells</translation>
    </message>
    <message>
        <source>Equal gaps in a row</source>
        <translation>Gleiche Abstände in einer Zeile</translation>
    </message>
    <message>
        <source>Equal gaps in a column</source>
        <translation>Gleiche Abstände in einer Spalte</translation>
    </message>
    <message>
        <source>Unit …</source>
        <translation>Einheit …</translation>
    </message>
    <message>
        <source>Unit of %1 (V, N.m, degC, rpm …)</source>
        <translation>Einheit von %1 (V, N.m, degC, rpm …)</translation>
    </message>
    <message>
        <source>Add text …</source>
        <translation>Text hinzufügen …</translation>
    </message>
    <message>
        <source>Add picture …</source>
        <translation>Bild hinzufügen …</translation>
    </message>
    <message>
        <source>Text in the diagram</source>
        <translation>Text im Diagramm</translation>
    </message>
</context>
<context>
    <name>Composer</name>
    <message>
        <source>Select the blocks that are to become one; inputs and outputs stay outside.</source>
        <translation>Wählen Sie die Blöcke, die zu einem werden sollen; Ein- und Ausgänge bleiben außerhalb.</translation>
    </message>
    <message>
        <source>"%1" is no free name for a model.</source>
        <translation>„%1“ ist kein freier Name für ein Modell.</translation>
    </message>
    <message>
        <source>Group %1 blocks</source>
        <translation>%1 Blöcke zusammenfassen</translation>
    </message>
    <message>
        <source>a flange</source>
        <translation>ein Flansch</translation>
    </message>
    <message>
        <source>a translational flange</source>
        <translation>ein translatorischer Flansch</translation>
    </message>
    <message>
        <source>an electrical pin</source>
        <translation>ein elektrischer Anschluss</translation>
    </message>
    <message>
        <source>a heat port</source>
        <translation>ein Wärmeanschluss</translation>
    </message>
    <message>
        <source>a signal input</source>
        <translation>ein Signaleingang</translation>
    </message>
    <message>
        <source>a signal output</source>
        <translation>ein Signalausgang</translation>
    </message>
    <message>
        <source>a connector of another kind</source>
        <translation>ein Anschluss anderer Art</translation>
    </message>
    <message>
        <source>The model's text has a fault: mend it first, then the diagram can be changed.</source>
        <translation>Der Modelltext hat einen Fehler: Ist er behoben, lässt sich das Diagramm wieder ändern.</translation>
    </message>
    <message>
        <source>There is no class %1.</source>
        <translation>Es gibt keine Klasse %1.</translation>
    </message>
    <message>
        <source>%1 is only a base for other classes and cannot be placed.</source>
        <translation>%1 ist nur die Grundlage anderer Klassen und kann nicht eingesetzt werden.</translation>
    </message>
    <message>
        <source>A model cannot hold itself.</source>
        <translation>Ein Modell kann sich nicht selbst enthalten.</translation>
    </message>
    <message>
        <source>Place %1</source>
        <translation>%1 einsetzen</translation>
    </message>
    <message>
        <source>Insert %1 between %2 and %3</source>
        <translation>%1 zwischen %2 und %3 einfügen</translation>
    </message>
    <message>
        <source>A connector cannot be connected with itself.</source>
        <translation>Ein Anschluss lässt sich nicht mit sich selbst verbinden.</translation>
    </message>
    <message>
        <source>%1 and %2 are connected already.</source>
        <translation>%1 und %2 sind schon verbunden.</translation>
    </message>
    <message>
        <source>%1 is %2, %3 is %4: they do not fit.</source>
        <translation>%1 ist %2, %3 ist %4: Das passt nicht zusammen.</translation>
    </message>
    <message>
        <source>%1 and %2 are connectors of different classes.</source>
        <translation>%1 und %2 sind Anschlüsse verschiedener Klassen.</translation>
    </message>
    <message>
        <source>Both %1 and %2 give a signal: one must take it.</source>
        <translation>%1 und %2 geben beide ein Signal: Einer muss es aufnehmen.</translation>
    </message>
    <message>
        <source>Neither %1 nor %2 gives a signal: one must be a source.</source>
        <translation>Weder %1 noch %2 gibt ein Signal: Einer muss die Quelle sein.</translation>
    </message>
    <message>
        <source>%1 gets a signal already: an input takes one only.</source>
        <translation>%1 erhält schon ein Signal: Ein Eingang nimmt nur eines auf.</translation>
    </message>
    <message>
        <source>Connect %1 with %2</source>
        <translation>%1 mit %2 verbinden</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>%1 löschen</translation>
    </message>
    <message>
        <source>Delete wires</source>
        <translation>Leitungen löschen</translation>
    </message>
    <message>
        <source>Delete %1 blocks</source>
        <translation>%1 Blöcke löschen</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 verschieben</translation>
    </message>
    <message>
        <source>Move %1 blocks</source>
        <translation>%1 Blöcke verschieben</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Flip left to right</source>
        <translation>Waagerecht spiegeln</translation>
    </message>
    <message>
        <source>Flip upside down</source>
        <translation>Senkrecht spiegeln</translation>
    </message>
    <message>
        <source>Distribute</source>
        <translation>Verteilen</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>Ausrichten</translation>
    </message>
    <message>
        <source>"%1" is no name: letters, digits and _ only, no digit first, no keyword.</source>
        <translation>„%1“ ist kein Name: nur Buchstaben, Ziffern und _, keine Ziffer am Anfang, kein Schlüsselwort.</translation>
    </message>
    <message>
        <source>The name "%1" is taken.</source>
        <translation>Der Name „%1“ ist vergeben.</translation>
    </message>
    <message>
        <source>Rename %1 to %2</source>
        <translation>%1 in %2 umbenennen</translation>
    </message>
    <message>
        <source>"%1" is no name for a model.</source>
        <translation>„%1“ ist kein Name für ein Modell.</translation>
    </message>
    <message>
        <source>Rename the model to %1</source>
        <translation>Modell in %1 umbenennen</translation>
    </message>
    <message>
        <source>The clipboard holds no blocks.</source>
        <translation>Die Zwischenablage enthält keine Blöcke.</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>%1 einfügen</translation>
    </message>
    <message>
        <source>Paste %1 blocks</source>
        <translation>%1 Blöcke einfügen</translation>
    </message>
    <message>
        <source>Lead the wire from %1 to %2</source>
        <translation>Leitung von %1 nach %2 legen</translation>
    </message>
    <message>
        <source>Add a text</source>
        <translation>Text hinzufügen</translation>
    </message>
    <message>
        <source>Add a picture</source>
        <translation>Bild hinzufügen</translation>
    </message>
    <message>
        <source>Move a text</source>
        <translation>Text verschieben</translation>
    </message>
    <message>
        <source>Move a picture</source>
        <translation>Bild verschieben</translation>
    </message>
    <message>
        <source>Change a text</source>
        <translation>Text ändern</translation>
    </message>
    <message>
        <source>Remove a text</source>
        <translation>Text entfernen</translation>
    </message>
    <message>
        <source>Remove a picture</source>
        <translation>Bild entfernen</translation>
    </message>
</context>
<context>
    <name>DiagramView</name>
    <message>
        <source>Diagram</source>
        <translation>Diagramm</translation>
    </message>
    <message>
        <source>Drag blocks here from the library,
or press A and type the name of a block.</source>
        <translation>Blöcke aus der Bibliothek hierher ziehen
oder A drücken und den Namen eines Blocks eingeben.</translation>
    </message>
</context>
<context>
    <name>Document</name>
    <message>
        <source>Analysing the model</source>
        <translation>Modell untersuchen</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 lesen</translation>
    </message>
    <message>
        <source>Reading what was recovered</source>
        <translation>Wiederhergestelltes lesen</translation>
    </message>
    <message>
        <source>Saving</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>Set %1</source>
        <translation>%1 setzen</translation>
    </message>
    <message>
        <source>Add what is proposed</source>
        <translation>Vorgeschlagenes aufnehmen</translation>
    </message>
    <message>
        <source>Go back to the run of %1</source>
        <translation>Zurück zum Lauf von %1</translation>
    </message>
</context>
<context>
    <name>ErrorCurve</name>
    <message>
        <source>Error during the run</source>
        <translation>Fehler während des Laufs</translation>
    </message>
    <message>
        <source>The error is drawn here while a run goes on.</source>
        <translation>Während eines Laufs wird hier der Fehler gezeichnet.</translation>
    </message>
    <message>
        <source>error %1 %</source>
        <translation>Fehler %1 %</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
</context>
<context>
    <name>FitPanel</name>
    <message>
        <source>effects</source>
        <translation>Effekte</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Anpassung</translation>
    </message>
    <message>
        <source>Validate</source>
        <translation>Validierung</translation>
    </message>
    <message>
        <source>Go back to this run</source>
        <translation>Zu diesem Lauf zurück</translation>
    </message>
    <message>
        <source>Least squares (Levenberg-Marquardt)</source>
        <translation>Kleinste Quadrate (Levenberg-Marquardt)</translation>
    </message>
    <message>
        <source>Nelder-Mead simplex</source>
        <translation>Nelder-Mead-Simplex</translation>
    </message>
    <message>
        <source>Subspace simplex (SBPLX)</source>
        <translation>Simplex in Unterräumen (SBPLX)</translation>
    </message>
    <message>
        <source>Quadratic model (BOBYQA)</source>
        <translation>Quadratisches Modell (BOBYQA)</translation>
    </message>
    <message>
        <source>Controlled random search (CRS2)</source>
        <translation>Gelenkte Zufallssuche (CRS2)</translation>
    </message>
    <message>
        <source>Stochastic ranking (ISRES)</source>
        <translation>Stochastische Rangfolge (ISRES)</translation>
    </message>
    <message>
        <source>Evolutionary search (ESCH)</source>
        <translation>Evolutionäre Suche (ESCH)</translation>
    </message>
    <message>
        <source>Plain squares</source>
        <translation>Fehlerquadrate</translation>
    </message>
    <message>
        <source>Huber: outliers count less</source>
        <translation>Huber: Ausreißer zählen weniger</translation>
    </message>
    <message>
        <source>Cauchy: outliers hardly count</source>
        <translation>Cauchy: Ausreißer zählen kaum</translation>
    </message>
    <message>
        <source>Fits from several starts within the bounds and keeps the best one</source>
        <translation>Passt von mehreren Startpunkten in den Grenzen an und behält das Beste</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Misfit</source>
        <translation>Fehlermaß</translation>
    </message>
    <message>
        <source>Starts</source>
        <translation>Startpunkte</translation>
    </message>
    <message>
        <source>Runs so far</source>
        <translation>Bisherige Läufe</translation>
    </message>
    <message>
        <source>How long it takes is not known yet.</source>
        <translation>Die Dauer ist noch nicht bekannt.</translation>
    </message>
    <message>
        <source>about %1 s left</source>
        <translation>noch etwa %1 s</translation>
    </message>
    <message>
        <source>took %1 s</source>
        <translation>dauerte %1 s</translation>
    </message>
    <message>
        <source>error, fit</source>
        <translation>Fehler, Anpassung</translation>
    </message>
    <message>
        <source>error, validate</source>
        <translation>Fehler, Validierung</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Anheften</translation>
    </message>
    <message>
        <source>A pinned run stays in the study, however many runs follow</source>
        <translation>Ein angehefteter Lauf bleibt in der Studie, wie viele Läufe auch folgen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Name of the run</source>
        <translation>Name des Laufs</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>Note on the run</source>
        <translation>Notiz zum Lauf</translation>
    </message>
    <message>
        <source>Choose several runs to compare them.</source>
        <translation>Mehrere Läufe wählen, um sie zu vergleichen.</translation>
    </message>
    <message>
        <source>The traces are those of the first and of the last.</source>
        <translation>Die Verläufe sind die des ersten und des letzten.</translation>
    </message>
    <message>
        <source>As many runs are pinned as a study keeps: loosen another first.</source>
        <translation>So viele Läufe sind angeheftet, wie eine Studie behält: zuerst einen anderen lösen.</translation>
    </message>
    <message>
        <source>error, %1</source>
        <translation>Fehler, %1</translation>
    </message>
    <message>
        <source>Comparison of runs</source>
        <translation>Vergleich von Läufen</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Simulate until</source>
        <translation>Simulieren bis</translation>
    </message>
    <message>
        <source>Every run of Simulate (F4), Fit (F5) and Discover (F6) is kept here.</source>
        <translation>Jeder Lauf von „Simulieren“ (F4), „Anpassen“ (F5) und „Effekt suchen“ (F6) bleibt hier erhalten.</translation>
    </message>
    <message>
        <source>Find a run</source>
        <translation>Lauf suchen</translation>
    </message>
</context>
<context>
    <name>GeneratePage</name>
    <message>
        <source>Component</source>
        <translation>Bauteil</translation>
    </message>
    <message>
        <source>Add to the chain</source>
        <translation>Zur Kette hinzufügen</translation>
    </message>
    <message>
        <source>Add recording …</source>
        <translation>Aufzeichnung hinzufügen …</translation>
    </message>
    <message>
        <source>Compose the study</source>
        <translation>Studie zusammensetzen</translation>
    </message>
    <message>
        <source>Generate a study</source>
        <translation>Eine Studie erzeugen</translation>
    </message>
    <message>
        <source>Say which domains the component joins, in the order of the chain, and give a recording: a first model is composed, its columns are mapped and start values come from the data.</source>
        <translation>Die Domänen des Bauteils in der Reihenfolge der Kette und eine Aufzeichnung angeben: Daraus entsteht ein erstes Modell, die Spalten werden zugeordnet, die Startwerte kommen aus den Daten.</translation>
    </message>
    <message>
        <source>Drag to change the order; Delete takes one out</source>
        <translation>Ziehen ändert die Reihenfolge; Entf nimmt einen heraus</translation>
    </message>
    <message>
        <source>Domains</source>
        <translation>Domänen</translation>
    </message>
    <message>
        <source>Chain of the component</source>
        <translation>Kette des Bauteils</translation>
    </message>
    <message>
        <source>Recordings (the last of several is kept for validation)</source>
        <translation>Aufzeichnungen (von mehreren dient die letzte der Validierung)</translation>
    </message>
    <message>
        <source>Name of the model</source>
        <translation>Name des Modells</translation>
    </message>
    <message>
        <source>Add recording</source>
        <translation>Aufzeichnung hinzufügen</translation>
    </message>
    <message>
        <source>Choose at least one domain.</source>
        <translation>Mindestens eine Domäne wählen.</translation>
    </message>
    <message>
        <source>Add a recording.</source>
        <translation>Eine Aufzeichnung hinzufügen.</translation>
    </message>
    <message>
        <source>The name must be a Modelica name: letters, digits and _.</source>
        <translation>Der Name muss ein Modelica-Name sein: Buchstaben, Ziffern und _.</translation>
    </message>
    <message>
        <source>Composing …</source>
        <translation>Setzt zusammen …</translation>
    </message>
    <message>
        <source>Composing</source>
        <translation>Zusammensetzen</translation>
    </message>
    <message>
        <source>Double-click a domain, or mark it and press Add to the chain.</source>
        <translation>Eine Domäne doppelklicken oder markieren und „Zur Kette hinzufügen“ drücken.</translation>
    </message>
    <message>
        <source>Drop measurement files here, or press Add recording.</source>
        <translation>Messdateien hierher ziehen oder „Aufzeichnung hinzufügen“ drücken.</translation>
    </message>
    <message>
        <source>Take out</source>
        <translation>Herausnehmen</translation>
    </message>
</context>
<context>
    <name>GuidePage</name>
    <message>
        <source>user-guide.md</source>
        <translation>user-guide.de.md</translation>
    </message>
    <message>
        <source>User guide</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>The guide is not installed.</source>
        <translation>Das Handbuch ist nicht installiert.</translation>
    </message>
    <message>
        <source>Close the guide</source>
        <translation>Handbuch schließen</translation>
    </message>
</context>
<context>
    <name>ImportPanel</name>
    <message>
        <source>%1 rows, %2 columns; a question is open.</source>
        <translation>%1 Zeilen, %2 Spalten; eine Frage ist offen.</translation>
    </message>
    <message>
        <source>Choose channels …</source>
        <translation>Kanäle wählen …</translation>
    </message>
    <message>
        <source>choose it</source>
        <translation>auswählen</translation>
    </message>
    <message>
        <source>No column is a time by its name or unit: choose the one that is.</source>
        <translation>Keine Spalte ist nach Namen oder Einheit eine Zeit: Wählen Sie die aus, die es ist.</translation>
    </message>
    <message>
        <source>The file holds %1 channels. Tick those that are to be read; the others stay in it.</source>
        <translation>Die Datei enthält %1 Kanäle. Haken Sie die an, die gelesen werden sollen; die anderen bleiben in ihr.</translation>
    </message>
    <message>
        <source>Add to the study</source>
        <translation>Zur Studie hinzufügen</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>Used to</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>Time column</source>
        <translation>Zeitspalte</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>%1 importieren</translation>
    </message>
    <message>
        <source>Reading …</source>
        <translation>Liest …</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>line %1: </source>
        <translation>Zeile %1: </translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>%1 rows, %2 columns; nothing is wrong with it.</source>
        <translation>%1 Zeilen, %2 Spalten; alles in Ordnung.</translation>
    </message>
    <message>
        <source>There are %1 times, each with channels of its own. Here they stand on the stamps of all, on straight lines between their own; a model takes each at its own.</source>
        <translation>Es gibt %1 Zeiten, jede mit eigenen Kanälen. Hier stehen sie auf den Zeitpunkten aller, zwischen ihren eigenen auf geraden Linien; ein Modell nimmt jeden an seinen eigenen.</translation>
    </message>
    <message>
        <source>In SI units</source>
        <translation>In SI-Einheiten</translation>
    </message>
    <message>
        <source>The values as a model in SI units gets them; the file stays as it is</source>
        <translation>Die Werte, wie sie ein Modell in SI-Einheiten erhält; die Datei bleibt, wie sie ist</translation>
    </message>
</context>
<context>
    <name>Library</name>
    <message>
        <source>Voltage drop of a diode or of brushes in a wire</source>
        <translation>Spannungsabfall einer Diode oder von Bürsten in einer Leitung</translation>
    </message>
    <message>
        <source>Leakage from a wire to ground</source>
        <translation>Leckstrom von einer Leitung nach Masse</translation>
    </message>
    <message>
        <source>Conductance 1/R_p to ground (0: off)</source>
        <translation>Leitwert 1/R_p nach Masse (0: aus)</translation>
    </message>
    <message>
        <source>Resistance 1/G_p (0 while there is no leakage)</source>
        <translation>Widerstand 1/G_p (0, solange es kein Leck gibt)</translation>
    </message>
    <message>
        <source>Effects in a circuit</source>
        <translation>Effekte in einem Stromkreis</translation>
    </message>
    <message>
        <source>Resistance of a lead or a contact</source>
        <translation>Widerstand einer Zuleitung oder eines Kontakts</translation>
    </message>
    <message>
        <source>Resistance (0: none)</source>
        <translation>Widerstand (0: keiner)</translation>
    </message>
    <message>
        <source>Potential of p against ground</source>
        <translation>Potential von p gegen Masse</translation>
    </message>
    <message>
        <source>Leakage between two wires that no component joins</source>
        <translation>Leckstrom zwischen zwei Leitungen, die kein Bauteil verbindet</translation>
    </message>
    <message>
        <source>Conductance 1/R_p between the wires (0: off)</source>
        <translation>Leitwert 1/R_p zwischen den Leitungen (0: aus)</translation>
    </message>
    <message>
        <source>Stray or filter capacitance from a wire to ground</source>
        <translation>Streu- oder Filterkapazität einer Leitung nach Masse</translation>
    </message>
    <message>
        <source>Capacitance (0: off)</source>
        <translation>Kapazität (0: aus)</translation>
    </message>
    <message>
        <source>Inductance of a lead or a loop</source>
        <translation>Induktivität einer Zuleitung oder Schleife</translation>
    </message>
    <message>
        <source>Inductance (0: none)</source>
        <translation>Induktivität (0: keine)</translation>
    </message>
    <message>
        <source>Dry friction of a rod</source>
        <translation>Trockene Reibung einer Stange</translation>
    </message>
    <message>
        <source>Friction force (0: off)</source>
        <translation>Reibkraft (0: aus)</translation>
    </message>
    <message>
        <source>Velocity over which the jump at standstill is smoothed</source>
        <translation>Geschwindigkeit, über die der Sprung im Stillstand geglättet ist</translation>
    </message>
    <message>
        <source>Effects on a rod</source>
        <translation>Effekte an einer Stange</translation>
    </message>
    <message>
        <source>Constant load force</source>
        <translation>Konstante Lastkraft</translation>
    </message>
    <message>
        <source>Force on the rod, positive against positive motion (0: off)</source>
        <translation>Kraft auf die Stange, positiv gegen positive Bewegung (0: aus)</translation>
    </message>
    <message>
        <source>Force proportional to the square of the velocity</source>
        <translation>Kraft proportional zum Quadrat der Geschwindigkeit</translation>
    </message>
    <message>
        <source>Force per square of the velocity (0: off)</source>
        <translation>Kraft je Quadrat der Geschwindigkeit (0: aus)</translation>
    </message>
    <message>
        <source>Play between two rods</source>
        <translation>Spiel zwischen zwei Stangen</translation>
    </message>
    <message>
        <source>Stiffness in contact</source>
        <translation>Steifigkeit im Kontakt</translation>
    </message>
    <message>
        <source>Damping in contact</source>
        <translation>Dämpfung im Kontakt</translation>
    </message>
    <message>
        <source>Distance over which the contact sets in</source>
        <translation>Weg, über den der Kontakt einsetzt</translation>
    </message>
    <message>
        <source>Distance: flange_b against flange_a</source>
        <translation>Abstand: flange_b gegen flange_a</translation>
    </message>
    <message>
        <source>Deflection in contact</source>
        <translation>Verformung im Kontakt</translation>
    </message>
    <message>
        <source>Force that is passed on</source>
        <translation>Weitergegebene Kraft</translation>
    </message>
    <message>
        <source>Velocity of flange_a</source>
        <translation>Geschwindigkeit von flange_a</translation>
    </message>
    <message>
        <source>Dry friction of a rod with extra breakaway force that falls off with velocity</source>
        <translation>Trockene Reibung einer Stange mit Losbrechkraft, die mit der Geschwindigkeit abfällt</translation>
    </message>
    <message>
        <source>Extra force at breakaway (0: off)</source>
        <translation>Zusätzliche Losbrechkraft (0: aus)</translation>
    </message>
    <message>
        <source>Friction force at speed</source>
        <translation>Reibkraft bei Bewegung</translation>
    </message>
    <message>
        <source>Velocity at which the extra force has fallen to 1/e</source>
        <translation>Geschwindigkeit, bei der die zusätzliche Kraft auf 1/e gefallen ist</translation>
    </message>
    <message>
        <source>Force proportional to the velocity</source>
        <translation>Kraft proportional zur Geschwindigkeit</translation>
    </message>
    <message>
        <source>Force per velocity (0: off)</source>
        <translation>Kraft je Geschwindigkeit (0: aus)</translation>
    </message>
    <message>
        <source>Further mass on the rod</source>
        <translation>Weitere Masse an der Stange</translation>
    </message>
    <message>
        <source>Mass (0: off)</source>
        <translation>Masse (0: aus)</translation>
    </message>
    <message>
        <source>Spring from a rod to the housing</source>
        <translation>Feder von einer Stange zum Gehäuse</translation>
    </message>
    <message>
        <source>Position at which the spring is relaxed</source>
        <translation>Position, bei der die Feder entspannt ist</translation>
    </message>
    <message>
        <source>Rod that gives way</source>
        <translation>Nachgiebige Stange</translation>
    </message>
    <message>
        <source>Stiffness 1/e (0 while the rod is rigid)</source>
        <translation>Steifigkeit 1/e (0, solange die Stange starr ist)</translation>
    </message>
    <message>
        <source>Elongation: flange_b against flange_a</source>
        <translation>Dehnung: flange_b gegen flange_a</translation>
    </message>
    <message>
        <source>Rate of elongation</source>
        <translation>Dehnungsgeschwindigkeit</translation>
    </message>
    <message>
        <source>Force in the rod</source>
        <translation>Kraft in der Stange</translation>
    </message>
    <message>
        <source>Inductor</source>
        <translation>Spule</translation>
    </message>
    <message>
        <source>Inductance</source>
        <translation>Induktivität</translation>
    </message>
    <message>
        <source>Resistor</source>
        <translation>Widerstand</translation>
    </message>
    <message>
        <source>Resistance</source>
        <translation>Widerstand</translation>
    </message>
    <message>
        <source>Electrical circuits: resistors, coils, capacitors, diodes and switches</source>
        <translation>Stromkreise: Widerstände, Spulen, Kondensatoren, Dioden und Schalter</translation>
    </message>
    <message>
        <source>Electromechanical conversion: voltage by speed, torque by current</source>
        <translation>Elektromechanische Wandlung: Spannung durch Drehzahl, Drehmoment durch Strom</translation>
    </message>
    <message>
        <source>Torque per current, which is voltage per speed</source>
        <translation>Drehmoment je Strom, zugleich Spannung je Drehzahl</translation>
    </message>
    <message>
        <source>Switch that a signal closes</source>
        <translation>Schalter, den ein Signal schließt</translation>
    </message>
    <message>
        <source>Closed where above 0.5</source>
        <translation>Geschlossen, wo über 0,5</translation>
    </message>
    <message>
        <source>Resistance of the closed switch</source>
        <translation>Widerstand des geschlossenen Schalters</translation>
    </message>
    <message>
        <source>Conductance of the open switch</source>
        <translation>Leitwert des offenen Schalters</translation>
    </message>
    <message>
        <source>Capacitor</source>
        <translation>Kondensator</translation>
    </message>
    <message>
        <source>Capacitance</source>
        <translation>Kapazität</translation>
    </message>
    <message>
        <source>Diode with an exponential characteristic</source>
        <translation>Diode mit exponentieller Kennlinie</translation>
    </message>
    <message>
        <source>Saturation current</source>
        <translation>Sättigungsstrom</translation>
    </message>
    <message>
        <source>Emission coefficient times thermal voltage</source>
        <translation>Emissionskoeffizient mal Temperaturspannung</translation>
    </message>
    <message>
        <source>Resistance in parallel</source>
        <translation>Parallelwiderstand</translation>
    </message>
    <message>
        <source>v/V_t, up to where the exponential goes on as its tangent</source>
        <translation>v/V_t, bis wo die Exponentialfunktion als ihre Tangente weiterläuft</translation>
    </message>
    <message>
        <source>Ground: the potential 0</source>
        <translation>Masse: das Potential 0</translation>
    </message>
    <message>
        <source>Grounded wire</source>
        <translation>Geerdete Leitung</translation>
    </message>
    <message>
        <source>Electrical pin (open: the negative side)</source>
        <translation>Elektrischer Anschluss (offen: die negative Seite)</translation>
    </message>
    <message>
        <source>Potential at the pin</source>
        <translation>Potential am Anschluss</translation>
    </message>
    <message>
        <source>Current into the component</source>
        <translation>Strom in das Bauteil</translation>
    </message>
    <message>
        <source>One pin with its potential</source>
        <translation>Ein Anschluss mit seinem Potential</translation>
    </message>
    <message>
        <source>Wire on which the component acts</source>
        <translation>Leitung, auf die das Bauteil wirkt</translation>
    </message>
    <message>
        <source>Potential of the pin against ground</source>
        <translation>Potential des Anschlusses gegen Masse</translation>
    </message>
    <message>
        <source>One translational flange with its position and velocity</source>
        <translation>Ein translatorischer Flansch mit Position und Geschwindigkeit</translation>
    </message>
    <message>
        <source>Rod on which the component acts</source>
        <translation>Stange, auf die das Bauteil wirkt</translation>
    </message>
    <message>
        <source>Position of the flange</source>
        <translation>Position des Flansches</translation>
    </message>
    <message>
        <source>Velocity of the flange</source>
        <translation>Geschwindigkeit des Flansches</translation>
    </message>
    <message>
        <source>Two pins, the voltage between them and the current through them</source>
        <translation>Zwei Anschlüsse, die Spannung dazwischen und der Strom hindurch</translation>
    </message>
    <message>
        <source>Positive side</source>
        <translation>Positive Seite</translation>
    </message>
    <message>
        <source>Negative side</source>
        <translation>Negative Seite</translation>
    </message>
    <message>
        <source>Voltage from p to n</source>
        <translation>Spannung von p nach n</translation>
    </message>
    <message>
        <source>Current from p to n</source>
        <translation>Strom von p nach n</translation>
    </message>
    <message>
        <source>Two translational flanges</source>
        <translation>Zwei translatorische Flansche</translation>
    </message>
    <message>
        <source>Left side of the rod</source>
        <translation>Linke Seite der Stange</translation>
    </message>
    <message>
        <source>Right side of the rod</source>
        <translation>Rechte Seite der Stange</translation>
    </message>
    <message>
        <source>Electrical pin (filled: the positive side)</source>
        <translation>Elektrischer Anschluss (gefüllt: die positive Seite)</translation>
    </message>
    <message>
        <source>Translational flange (filled: the side that usually drives)</source>
        <translation>Translatorischer Flansch (gefüllt: die meist treibende Seite)</translation>
    </message>
    <message>
        <source>Position of the rod</source>
        <translation>Position der Stange</translation>
    </message>
    <message>
        <source>Force into the component</source>
        <translation>Kraft in das Bauteil</translation>
    </message>
    <message>
        <source>Translational flange (open: the side that is usually driven)</source>
        <translation>Translatorischer Flansch (offen: die meist getriebene Seite)</translation>
    </message>
    <message>
        <source>Ideal current sensor in a wire</source>
        <translation>Idealer Stromsensor in einer Leitung</translation>
    </message>
    <message>
        <source>Side into which the current counts</source>
        <translation>Seite, in die der Strom zählt</translation>
    </message>
    <message>
        <source>Ideal force sensor between two flanges</source>
        <translation>Idealer Kraftsensor zwischen zwei Flanschen</translation>
    </message>
    <message>
        <source>Force that the rod passes on from flange_a to flange_b</source>
        <translation>Kraft, die die Stange von flange_a an flange_b weitergibt</translation>
    </message>
    <message>
        <source>Ideal position sensor</source>
        <translation>Idealer Wegsensor</translation>
    </message>
    <message>
        <source>Rod that is observed</source>
        <translation>Beobachtete Stange</translation>
    </message>
    <message>
        <source>Ideal velocity sensor</source>
        <translation>Idealer Geschwindigkeitssensor</translation>
    </message>
    <message>
        <source>Ideal voltage sensor between two pins</source>
        <translation>Idealer Spannungssensor zwischen zwei Anschlüssen</translation>
    </message>
    <message>
        <source>Imposes a current given by a signal</source>
        <translation>Prägt einen Strom ein, den ein Signal vorgibt</translation>
    </message>
    <message>
        <source>Current from p to n through the source</source>
        <translation>Strom von p nach n durch die Quelle</translation>
    </message>
    <message>
        <source>Imposes a force given by a signal</source>
        <translation>Prägt eine Kraft ein, die ein Signal vorgibt</translation>
    </message>
    <message>
        <source>Force to give out</source>
        <translation>Abzugebende Kraft</translation>
    </message>
    <message>
        <source>Rod that is driven</source>
        <translation>Angetriebene Stange</translation>
    </message>
    <message>
        <source>Imposes a voltage given by a signal</source>
        <translation>Prägt eine Spannung ein, die ein Signal vorgibt</translation>
    </message>
    <message>
        <source>Translational mechanics: rods, masses and springs</source>
        <translation>Translatorische Mechanik: Stangen, Massen und Federn</translation>
    </message>
    <message>
        <source>Ideal rack and pinion, or spindle</source>
        <translation>Ideale Zahnstange mit Ritzel, oder Spindel</translation>
    </message>
    <message>
        <source>Shaft of the pinion</source>
        <translation>Welle des Ritzels</translation>
    </message>
    <message>
        <source>Rack</source>
        <translation>Zahnstange</translation>
    </message>
    <message>
        <source>Travel per angle (radius of the pinion; pitch/(2*pi) of a spindle)</source>
        <translation>Weg je Winkel (Radius des Ritzels; Steigung/(2*pi) einer Spindel)</translation>
    </message>
    <message>
        <source>Linear spring and damper in parallel between two translational flanges</source>
        <translation>Lineare Feder und Dämpfer parallel zwischen zwei translatorischen Flanschen</translation>
    </message>
    <message>
        <source>Length of the relaxed spring</source>
        <translation>Länge der entspannten Feder</translation>
    </message>
    <message>
        <source>Rate of the distance</source>
        <translation>Änderung des Abstands</translation>
    </message>
    <message>
        <source>Force of spring and damper</source>
        <translation>Kraft von Feder und Dämpfer</translation>
    </message>
    <message>
        <source>Rigid body that slides</source>
        <translation>Starrer Körper, der gleitet</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Flange held at a fixed position</source>
        <translation>Flansch, auf fester Position gehalten</translation>
    </message>
    <message>
        <source>Electric machine with several effects, a warm winding and warm magnets among them</source>
        <translation>Elektrische Maschine mit mehreren Effekten, darunter eine warme Wicklung und warme Magnete</translation>
    </message>
    <message>
        <source>Heating of the magnets per loss, 1/C_m (0: off)</source>
        <translation>Erwärmung der Magnete je Verlust, 1/C_m (0: aus)</translation>
    </message>
    <message>
        <source>Time constant with which the magnets cool, C_m/G_m</source>
        <translation>Zeitkonstante, mit der die Magnete abkühlen, C_m/G_m</translation>
    </message>
    <message>
        <source>Heat capacity of the magnets (0 while off)</source>
        <translation>Wärmekapazität der Magnete (0, solange aus)</translation>
    </message>
    <message>
        <source>Conductance from the magnets to their surroundings (0 while off)</source>
        <translation>Leitwert von den Magneten zur Umgebung (0, solange aus)</translation>
    </message>
    <message>
        <source>Magnets over their temperature at the start</source>
        <translation>Magnete über ihrer Temperatur am Anfang</translation>
    </message>
    <message>
        <source>Resistance of leads, drop of brushes, saturation of the inductance, a winding that its loss warms and magnets that it warms too, each with a heat balance of its own, in one machine. What is not asked for is off.</source>
        <translation>Widerstand der Leitungen, Abfall der Bürsten, Sättigung der Induktivität, eine Wicklung, die ihr Verlust erwärmt, und Magnete, die er ebenfalls erwärmt, jede mit eigener Wärmebilanz, in einer Maschine. Was nicht verlangt ist, ist aus.</translation>
    </message>
    <message>
        <source>Abscissa at which the value is wanted</source>
        <translation>Abszisse, an der der Wert gesucht ist</translation>
    </message>
    <message>
        <source>Abscissas of the points, rising</source>
        <translation>Abszissen der Punkte, steigend</translation>
    </message>
    <message>
        <source>Ordinates of the points</source>
        <translation>Ordinaten der Punkte</translation>
    </message>
    <message>
        <source>Slope of each piece</source>
        <translation>Steigung jedes Stücks</translation>
    </message>
    <message>
        <source>Slope at each point</source>
        <translation>Steigung an jedem Punkt</translation>
    </message>
    <message>
        <source>Way from the left end of the piece</source>
        <translation>Weg vom linken Ende des Stücks</translation>
    </message>
    <message>
        <source>Width of the piece</source>
        <translation>Breite des Stücks</translation>
    </message>
    <message>
        <source>Torque to give out</source>
        <translation>Abzugebendes Drehmoment</translation>
    </message>
    <message>
        <source>Shaft that is driven</source>
        <translation>Angetriebene Welle</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>Value, in the unit of what is connected</source>
        <translation>Wert, in der Einheit dessen, was verbunden ist</translation>
    </message>
    <message>
        <source>Temperature to impose</source>
        <translation>Aufzuprägende Temperatur</translation>
    </message>
    <message>
        <source>Place that is kept at T</source>
        <translation>Ort, der auf T gehalten wird</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>Heat to give out</source>
        <translation>Abzugebende Wärme</translation>
    </message>
    <message>
        <source>Place that is heated</source>
        <translation>Ort, der geheizt wird</translation>
    </message>
    <message>
        <source>Friction torque per speed</source>
        <translation>Reibmoment je Drehzahl</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>Friction torque</source>
        <translation>Reibmoment</translation>
    </message>
    <message>
        <source>The body</source>
        <translation>Der Körper</translation>
    </message>
    <message>
        <source>Heat capacity</source>
        <translation>Wärmekapazität</translation>
    </message>
    <message>
        <source>Temperature at the start</source>
        <translation>Temperatur zu Beginn</translation>
    </message>
    <message>
        <source>One side</source>
        <translation>Eine Seite</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>Andere Seite</translation>
    </message>
    <message>
        <source>Conductance</source>
        <translation>Leitwert</translation>
    </message>
    <message>
        <source>port_a against port_b</source>
        <translation>port_a gegen port_b</translation>
    </message>
    <message>
        <source>Heat from port_a to port_b</source>
        <translation>Wärme von port_a nach port_b</translation>
    </message>
    <message>
        <source>Voltage at the terminals</source>
        <translation>Spannung an den Klemmen</translation>
    </message>
    <message>
        <source>Current drawn</source>
        <translation>Aufgenommener Strom</translation>
    </message>
    <message>
        <source>Shaft</source>
        <translation>Welle</translation>
    </message>
    <message>
        <source>Resistance of the winding</source>
        <translation>Widerstand der Wicklung</translation>
    </message>
    <message>
        <source>Inductance of the winding</source>
        <translation>Induktivität der Wicklung</translation>
    </message>
    <message>
        <source>Torque constant, equal to the voltage constant</source>
        <translation>Drehmomentkonstante, gleich der Spannungskonstante</translation>
    </message>
    <message>
        <source>Speed of the shaft</source>
        <translation>Drehzahl der Welle</translation>
    </message>
    <message>
        <source>Torque per square of the speed</source>
        <translation>Drehmoment je Quadrat der Drehzahl</translation>
    </message>
    <message>
        <source>Moment of inertia</source>
        <translation>Trägheitsmoment</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>Torque per speed</source>
        <translation>Drehmoment je Drehzahl</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>Twist: flange_b against flange_a</source>
        <translation>Verdrehung: flange_b gegen flange_a</translation>
    </message>
    <message>
        <source>Rate of twist</source>
        <translation>Geschwindigkeit der Verdrehung</translation>
    </message>
    <message>
        <source>Torque of spring and damper</source>
        <translation>Drehmoment von Feder und Dämpfer</translation>
    </message>
    <message>
        <source>Stiffness of the shaft, on the side of flange_b</source>
        <translation>Steifigkeit der Welle, auf der Seite von flange_b</translation>
    </message>
    <message>
        <source>Damping of the shaft, on the side of flange_b</source>
        <translation>Dämpfung der Welle, auf der Seite von flange_b</translation>
    </message>
    <message>
        <source>Gear ratio: turns of flange_a per turn of flange_b</source>
        <translation>Übersetzung: Umdrehungen von flange_a je Umdrehung von flange_b</translation>
    </message>
    <message>
        <source>Inertia at flange_a</source>
        <translation>Trägheitsmoment an flange_a</translation>
    </message>
    <message>
        <source>Inertia at flange_b</source>
        <translation>Trägheitsmoment an flange_b</translation>
    </message>
    <message>
        <source>Angle of the first inertia</source>
        <translation>Winkel der ersten Trägheit</translation>
    </message>
    <message>
        <source>Speed of the first inertia</source>
        <translation>Drehzahl der ersten Trägheit</translation>
    </message>
    <message>
        <source>Angle of the second inertia</source>
        <translation>Winkel der zweiten Trägheit</translation>
    </message>
    <message>
        <source>Speed of the second inertia</source>
        <translation>Drehzahl der zweiten Trägheit</translation>
    </message>
    <message>
        <source>Torque in the shaft, on the side of flange_b</source>
        <translation>Drehmoment in der Welle, auf der Seite von flange_b</translation>
    </message>
    <message>
        <source>Angle at which the spring is relaxed</source>
        <translation>Winkel, bei dem die Feder entspannt ist</translation>
    </message>
    <message>
        <source>Twist of the spring</source>
        <translation>Verdrehung der Feder</translation>
    </message>
    <message>
        <source>Held flange</source>
        <translation>Festgehaltener Flansch</translation>
    </message>
    <message>
        <source>The stream</source>
        <translation>Die Strömung</translation>
    </message>
    <message>
        <source>Heat capacity of the body</source>
        <translation>Wärmekapazität des Körpers</translation>
    </message>
    <message>
        <source>Coefficient of the law of convection</source>
        <translation>Koeffizient des Konvektionsgesetzes</translation>
    </message>
    <message>
        <source>Surface in the stream</source>
        <translation>Oberfläche in der Strömung</translation>
    </message>
    <message>
        <source>Temperature of the body at the start</source>
        <translation>Temperatur des Körpers zu Beginn</translation>
    </message>
    <message>
        <source>Conductance of the convection</source>
        <translation>Leitwert der Konvektion</translation>
    </message>
    <message>
        <source>Heat from the body to the stream</source>
        <translation>Wärme vom Körper an die Strömung</translation>
    </message>
    <message>
        <source>Body against stream</source>
        <translation>Körper gegen Strömung</translation>
    </message>
    <message>
        <source>Speed of the stream</source>
        <translation>Geschwindigkeit der Strömung</translation>
    </message>
    <message>
        <source>First signal in</source>
        <translation>Erstes Eingangssignal</translation>
    </message>
    <message>
        <source>Second signal in</source>
        <translation>Zweites Eingangssignal</translation>
    </message>
    <message>
        <source>Signal out</source>
        <translation>Ausgangssignal</translation>
    </message>
    <message>
        <source>Signal in</source>
        <translation>Eingangssignal</translation>
    </message>
    <message>
        <source>Factor, in the unit of y over u</source>
        <translation>Faktor, in der Einheit von y durch u</translation>
    </message>
    <message>
        <source>Time constant</source>
        <translation>Zeitkonstante</translation>
    </message>
    <message>
        <source>Place at which heat is exchanged</source>
        <translation>Ort, an dem Wärme ausgetauscht wird</translation>
    </message>
    <message>
        <source>Temperature of the port</source>
        <translation>Temperatur des Anschlusses</translation>
    </message>
    <message>
        <source>Angle of the shaft</source>
        <translation>Winkel der Welle</translation>
    </message>
    <message>
        <source>Left side of the shaft</source>
        <translation>Linke Seite der Welle</translation>
    </message>
    <message>
        <source>Right side of the shaft</source>
        <translation>Rechte Seite der Welle</translation>
    </message>
    <message>
        <source>Shaft on which the component acts</source>
        <translation>Welle, auf die das Bauteil wirkt</translation>
    </message>
    <message>
        <source>Angle of the flange</source>
        <translation>Winkel des Flansches</translation>
    </message>
    <message>
        <source>Speed of the flange</source>
        <translation>Drehzahl des Flansches</translation>
    </message>
    <message>
        <source>Resistance at T_ref</source>
        <translation>Widerstand bei T_ref</translation>
    </message>
    <message>
        <source>Temperature coefficient of the resistance</source>
        <translation>Temperaturkoeffizient des Widerstands</translation>
    </message>
    <message>
        <source>Temperature at which the resistance is R</source>
        <translation>Temperatur, bei der der Widerstand R beträgt</translation>
    </message>
    <message>
        <source>Resistance at the present temperature</source>
        <translation>Widerstand bei der augenblicklichen Temperatur</translation>
    </message>
    <message>
        <source>Recorded temperature of the surroundings</source>
        <translation>Aufgezeichnete Temperatur der Umgebung</translation>
    </message>
    <message>
        <source>Net radiation conductance: emissivity times surface times the Stefan-Boltzmann constant (0: off)</source>
        <translation>Netto-Strahlungsleitwert: Emissionsgrad mal Oberfläche mal Stefan-Boltzmann-Konstante (0: aus)</translation>
    </message>
    <message>
        <source>Temperature of the surroundings</source>
        <translation>Temperatur der Umgebung</translation>
    </message>
    <message>
        <source>Resistance 1/G (0: none)</source>
        <translation>Widerstand 1/G (0: keiner)</translation>
    </message>
    <message>
        <source>Conductance 1/R_th (0 while there is no resistance)</source>
        <translation>Leitwert 1/R_th (0, solange es keinen Widerstand gibt)</translation>
    </message>
    <message>
        <source>Temperature of port_a</source>
        <translation>Temperatur von port_a</translation>
    </message>
    <message>
        <source>Heat capacity of the second mass (0: off)</source>
        <translation>Wärmekapazität der zweiten Masse (0: aus)</translation>
    </message>
    <message>
        <source>Time constant with which the second mass follows</source>
        <translation>Zeitkonstante, mit der die zweite Masse folgt</translation>
    </message>
    <message>
        <source>Conductance between the masses: follows from the two above</source>
        <translation>Leitwert zwischen den Massen: folgt aus den beiden darüber</translation>
    </message>
    <message>
        <source>Temperature of the second mass</source>
        <translation>Temperatur der zweiten Masse</translation>
    </message>
    <message>
        <source>Mass of the heated element itself</source>
        <translation>Masse des beheizten Elements selbst</translation>
    </message>
    <message>
        <source>Source of heat</source>
        <translation>Wärmequelle</translation>
    </message>
    <message>
        <source>Heated body</source>
        <translation>Beheizter Körper</translation>
    </message>
    <message>
        <source>Time constant C_s/G_s with which the element passes its heat on (0: off)</source>
        <translation>Zeitkonstante C_s/G_s, mit der das Element seine Wärme weitergibt (0: aus)</translation>
    </message>
    <message>
        <source>Heat capacity of the element (0: small against that of the body)</source>
        <translation>Wärmekapazität des Elements (0: klein gegen die des Körpers)</translation>
    </message>
    <message>
        <source>Conductance to the body: follows from the two above</source>
        <translation>Leitwert zum Körper: folgt aus den beiden oben</translation>
    </message>
    <message>
        <source>Its inverse (0 while the capacity is small)</source>
        <translation>Sein Kehrwert (0, solange die Kapazität klein ist)</translation>
    </message>
    <message>
        <source>Heat that the element passes on</source>
        <translation>Wärme, die das Element weitergibt</translation>
    </message>
    <message>
        <source>Temperature of the body</source>
        <translation>Temperatur des Körpers</translation>
    </message>
    <message>
        <source>Temperature of the element</source>
        <translation>Temperatur des Elements</translation>
    </message>
    <message>
        <source>The element that turns power into heat (a cartridge, a winding, a wire) stores heat itself, and passes it on to the body through a conductance G_s. As long as nothing depends on the temperature of the element, only its time constant C_s/G_s can be told.</source>
        <translation>Das Element, das Leistung in Wärme wandelt (eine Patrone, eine Wicklung, ein Draht), speichert selbst Wärme und gibt sie über einen Leitwert G_s an den Körper weiter. Solange nichts von der Temperatur des Elements abhängt, lässt sich nur seine Zeitkonstante C_s/G_s angeben.</translation>
    </message>
    <message>
        <source>With C_s = 0 the capacity is small against that of the body: tau_s*der(Q_flow) = port_a.Q_flow - Q_flow, and the element is not told to be hotter. It begins in balance with its source.</source>
        <translation>Mit C_s = 0 ist die Kapazität klein gegen die des Körpers: tau_s*der(Q_flow) = port_a.Q_flow - Q_flow, und wie viel heißer das Element ist, wird nicht gesagt. Es beginnt im Gleichgewicht mit seiner Quelle.</translation>
    </message>
    <message>
        <source>Soft coupling between shafts that are not neighbours</source>
        <translation>Weiche Kopplung von Wellen, die nicht benachbart sind</translation>
    </message>
    <message>
        <source>Twist at which the coupling is relaxed</source>
        <translation>Verdrehung, bei der die Kopplung entspannt ist</translation>
    </message>
    <message>
        <source>Compliance 1/c (0 while there is no coupling)</source>
        <translation>Nachgiebigkeit 1/c (0, solange keine Kopplung besteht)</translation>
    </message>
    <message>
        <source>Torque in the coupling</source>
        <translation>Drehmoment in der Kopplung</translation>
    </message>
    <message>
        <source>A spring with a damper between two shafts that the model does not join: a belt, a hose, a common housing. The strength is the stiffness c, so that 0 leaves them apart; its inverse e is told beside it.</source>
        <translation>Eine Feder mit Dämpfer zwischen zwei Wellen, die das Modell nicht verbindet: ein Riemen, ein Schlauch, ein gemeinsames Gehäuse. Die Stärke ist die Steifigkeit c, sodass 0 sie getrennt lässt; ihr Kehrwert e wird daneben angegeben.</translation>
    </message>
    <message>
        <source>Curved characteristic of an input channel</source>
        <translation>Gekrümmte Kennlinie eines Eingangskanals</translation>
    </message>
    <message>
        <source>Exponent beyond that of proportion (0: off)</source>
        <translation>Exponent über den der Proportionalität hinaus (0: aus)</translation>
    </message>
    <message>
        <source>Command that passes unchanged</source>
        <translation>Stellwert, der unverändert durchgeht</translation>
    </message>
    <message>
        <source>Command below which the power is smoothed</source>
        <translation>Stellwert, unter dem die Potenz geglättet ist</translation>
    </message>
    <message>
        <source>A torque, a power or a flow that is no multiple of the command: a heater behind a voltage gives the square (p = 1), a valve or a lamp driver another power. Inserted behind an input.</source>
        <translation>Ein Drehmoment, eine Leistung oder ein Strom, der kein Vielfaches des Stellwerts ist: ein Heizer hinter einer Spannung gibt das Quadrat (p = 1), ein Ventil oder ein Lampentreiber eine andere Potenz. Hinter einem Eingang eingefügt.</translation>
    </message>
    <message>
        <source>The power is smoothed below u_eps so that it has a slope at 0. At u_ref the command passes unchanged.</source>
        <translation>Die Potenz ist unter u_eps geglättet, damit sie bei 0 eine Steigung hat. Bei u_ref geht der Stellwert unverändert durch.</translation>
    </message>
    <message>
        <source>Measured channel without its sign</source>
        <translation>Messkanal ohne Vorzeichen</translation>
    </message>
    <message>
        <source>Share of the sign that is lost (0: off, 1: a sensor without sign)</source>
        <translation>Anteil des Vorzeichens, der verloren geht (0: aus, 1: ein Sensor ohne Vorzeichen)</translation>
    </message>
    <message>
        <source>A tachometer, a flow meter or a rectifying transducer that tells the size of a quantity and not its sign. Inserted in front of a measured output.</source>
        <translation>Ein Tachometer, ein Durchflussmesser oder ein gleichrichtender Aufnehmer, der die Größe eines Werts angibt und nicht sein Vorzeichen. Vor einem gemessenen Ausgang eingefügt.</translation>
    </message>
    <message>
        <source>Heat exchange between places that are not neighbours</source>
        <translation>Wärmeaustausch zwischen Orten, die nicht benachbart sind</translation>
    </message>
    <message>
        <source>One place</source>
        <translation>Ein Ort</translation>
    </message>
    <message>
        <source>Other place</source>
        <translation>Anderer Ort</translation>
    </message>
    <message>
        <source>Conductance between the places (0: off)</source>
        <translation>Leitwert zwischen den Orten (0: aus)</translation>
    </message>
    <message>
        <source>Heat that passes between two places that the model does not join: through a board, a housing, the air between them.</source>
        <translation>Wärme, die zwischen zwei Orten übergeht, die das Modell nicht verbindet: durch eine Platine, ein Gehäuse, die Luft dazwischen.</translation>
    </message>
    <message>
        <source>Conductance to the surroundings (0: off)</source>
        <translation>Leitwert zur Umgebung (0: aus)</translation>
    </message>
    <message>
        <source>Heat of evaporation or melting (0: off)</source>
        <translation>Verdampfungs- oder Schmelzwärme (0: aus)</translation>
    </message>
    <message>
        <source>Temperature around which it is taken up</source>
        <translation>Temperatur, um die sie aufgenommen wird</translation>
    </message>
    <message>
        <source>Width of the range in which it is taken up</source>
        <translation>Breite des Bereichs, in dem sie aufgenommen wird</translation>
    </message>
    <message>
        <source>Time constant with which the front follows the temperature</source>
        <translation>Zeitkonstante, mit der die Front der Temperatur folgt</translation>
    </message>
    <message>
        <source>Highest temperature so far</source>
        <translation>Bisher höchste Temperatur</translation>
    </message>
    <message>
        <source>Rate of the highest temperature</source>
        <translation>Änderungsrate der höchsten Temperatur</translation>
    </message>
    <message>
        <source>1 within the range, 0 outside</source>
        <translation>1 im Bereich, 0 außerhalb</translation>
    </message>
    <message>
        <source>Heating of the winding per loss, 1/C_w (0: off)</source>
        <translation>Erwärmung der Wicklung je Verlust, 1/C_w (0: aus)</translation>
    </message>
    <message>
        <source>Time constant with which the winding cools, C_w/G_w</source>
        <translation>Zeitkonstante, mit der die Wicklung abkühlt, C_w/G_w</translation>
    </message>
    <message>
        <source>Heat capacity of the winding (0 while off)</source>
        <translation>Wärmekapazität der Wicklung (0, solange aus)</translation>
    </message>
    <message>
        <source>Conductance from the winding to its surroundings (0 while off)</source>
        <translation>Leitwert von der Wicklung zu ihrer Umgebung (0, solange aus)</translation>
    </message>
    <message>
        <source>Loss of torque constant per temperature (ferrite magnets)</source>
        <translation>Verlust an Drehmomentkonstante je Temperatur (Ferritmagnete)</translation>
    </message>
    <message>
        <source>Winding over its temperature at the start</source>
        <translation>Wicklung über ihrer Temperatur zu Beginn</translation>
    </message>
    <message>
        <source>Loss in the winding</source>
        <translation>Verlust in der Wicklung</translation>
    </message>
    <message>
        <source>Torque constant at the present temperature</source>
        <translation>Drehmomentkonstante bei der augenblicklichen Temperatur</translation>
    </message>
    <message>
        <source>Voltage drop (0: off)</source>
        <translation>Spannungsabfall (0: aus)</translation>
    </message>
    <message>
        <source>Current over which the change of sign is smoothed</source>
        <translation>Strom, über den der Vorzeichenwechsel geglättet wird</translation>
    </message>
    <message>
        <source>Fall of the torque constant per kelvin (0: off)</source>
        <translation>Abfall der Drehmomentkonstante je Kelvin (0: aus)</translation>
    </message>
    <message>
        <source>Temperature at which the torque constant is k</source>
        <translation>Temperatur, bei der die Drehmomentkonstante k beträgt</translation>
    </message>
    <message>
        <source>Torque constant</source>
        <translation>Drehmomentkonstante</translation>
    </message>
    <message>
        <source>Where the temperature is taken; no heat flows</source>
        <translation>Wo die Temperatur abgegriffen wird; es fließt keine Wärme</translation>
    </message>
    <message>
        <source>Temperature coefficient of the resistance (copper)</source>
        <translation>Temperaturkoeffizient des Widerstands (Kupfer)</translation>
    </message>
    <message>
        <source>Resistance outside the winding (0: off)</source>
        <translation>Widerstand außerhalb der Wicklung (0: aus)</translation>
    </message>
    <message>
        <source>Saturation 1/i_s: at the current i_s half of the inductance is left (0: off)</source>
        <translation>Sättigung 1/i_s: Beim Strom i_s ist die halbe Induktivität übrig (0: aus)</translation>
    </message>
    <message>
        <source>Current at which half of the inductance is left (0 while off)</source>
        <translation>Strom, bei dem die halbe Induktivität übrig ist (0, solange aus)</translation>
    </message>
    <message>
        <source>Inductance at the present current</source>
        <translation>Induktivität beim augenblicklichen Strom</translation>
    </message>
    <message>
        <source>Temperature coefficient of the resistance (0: off)</source>
        <translation>Temperaturkoeffizient des Widerstands (0: aus)</translation>
    </message>
    <message>
        <source>Temperature at which resistance and torque constant are R and k</source>
        <translation>Temperatur, bei der Widerstand und Drehmomentkonstante R und k betragen</translation>
    </message>
    <message>
        <source>Friction torque (0: off)</source>
        <translation>Reibmoment (0: aus)</translation>
    </message>
    <message>
        <source>Speed over which the jump at standstill is smoothed</source>
        <translation>Drehzahl, über die der Sprung im Stillstand geglättet wird</translation>
    </message>
    <message>
        <source>Largest torque (0: off)</source>
        <translation>Größtes Drehmoment (0: aus)</translation>
    </message>
    <message>
        <source>Angle at which the mass hangs at its lowest point</source>
        <translation>Winkel, bei dem die Masse am tiefsten Punkt hängt</translation>
    </message>
    <message>
        <source>Periods per turn</source>
        <translation>Perioden je Umdrehung</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>Torque per square of the speed (0: off)</source>
        <translation>Drehmoment je Quadrat der Drehzahl (0: aus)</translation>
    </message>
    <message>
        <source>Width of the play (0: none)</source>
        <translation>Breite des Spiels (0: keines)</translation>
    </message>
    <message>
        <source>Stiffness of the teeth in contact</source>
        <translation>Steifigkeit der Zähne im Eingriff</translation>
    </message>
    <message>
        <source>Damping of the teeth in contact</source>
        <translation>Dämpfung der Zähne im Eingriff</translation>
    </message>
    <message>
        <source>Angle over which the contact sets in</source>
        <translation>Winkel, über den der Kontakt einsetzt</translation>
    </message>
    <message>
        <source>Angle of flange_b against flange_a</source>
        <translation>Winkel von flange_b gegen flange_a</translation>
    </message>
    <message>
        <source>Its rate</source>
        <translation>Seine Änderungsrate</translation>
    </message>
    <message>
        <source>Deflection of the teeth</source>
        <translation>Verformung der Zähne</translation>
    </message>
    <message>
        <source>1 in contact, 0 in the play</source>
        <translation>1 im Kontakt, 0 im Spiel</translation>
    </message>
    <message>
        <source>Torque that is passed on</source>
        <translation>Weitergegebenes Drehmoment</translation>
    </message>
    <message>
        <source>Speed of flange_a</source>
        <translation>Drehzahl von flange_a</translation>
    </message>
    <message>
        <source>Torque on the shaft, positive against positive motion (0: off)</source>
        <translation>Drehmoment auf die Welle, positiv gegen positive Bewegung (0: aus)</translation>
    </message>
    <message>
        <source>Extra torque at breakaway (0: off)</source>
        <translation>Zusätzliches Losbrechmoment (0: aus)</translation>
    </message>
    <message>
        <source>Friction torque at speed</source>
        <translation>Reibmoment bei Drehzahl</translation>
    </message>
    <message>
        <source>Speed at which the extra torque has fallen to 1/e</source>
        <translation>Drehzahl, bei der das zusätzliche Moment auf 1/e gefallen ist</translation>
    </message>
    <message>
        <source>Moment of inertia (0: off)</source>
        <translation>Trägheitsmoment (0: aus)</translation>
    </message>
    <message>
        <source>Torque per speed (0: off)</source>
        <translation>Drehmoment je Drehzahl (0: aus)</translation>
    </message>
    <message>
        <source>Stiffness (0: off)</source>
        <translation>Steifigkeit (0: aus)</translation>
    </message>
    <message>
        <source>Compliance 1/c (0: rigid)</source>
        <translation>Nachgiebigkeit 1/c (0: starr)</translation>
    </message>
    <message>
        <source>Stiffness 1/e (0 while the shaft is rigid)</source>
        <translation>Steifigkeit 1/e (0, solange die Welle starr ist)</translation>
    </message>
    <message>
        <source>Torque in the shaft</source>
        <translation>Drehmoment in der Welle</translation>
    </message>
    <message>
        <source>Drift, unit of the signal per second (0: off)</source>
        <translation>Drift, Einheit des Signals je Sekunde (0: aus)</translation>
    </message>
    <message>
        <source>Time since the start of the recording</source>
        <translation>Zeit seit Beginn der Aufzeichnung</translation>
    </message>
    <message>
        <source>Recorded flow of the stream</source>
        <translation>Aufgezeichneter Durchfluss der Strömung</translation>
    </message>
    <message>
        <source>Recorded flow on the other side</source>
        <translation>Aufgezeichneter Durchfluss der anderen Seite</translation>
    </message>
    <message>
        <source>Exponent of the flow (0: off)</source>
        <translation>Exponent des Durchflusses (0: aus)</translation>
    </message>
    <message>
        <source>Flow at which the conductance is that without the effect</source>
        <translation>Durchfluss, bei dem der Leitwert der ohne den Effekt ist</translation>
    </message>
    <message>
        <source>Exponent of the temperature difference (0: off)</source>
        <translation>Exponent der Temperaturdifferenz (0: aus)</translation>
    </message>
    <message>
        <source>Difference at which the conductance is that without the effect</source>
        <translation>Differenz, bei der der Leitwert der ohne den Effekt ist</translation>
    </message>
    <message>
        <source>Difference below which the power is smoothed</source>
        <translation>Differenz, unter der die Potenz geglättet wird</translation>
    </message>
    <message>
        <source>1/limit (0: no limit)</source>
        <translation>1/Grenze (0: keine Grenze)</translation>
    </message>
    <message>
        <source>Limit, in the unit of the signal (0 while there is none)</source>
        <translation>Grenze, in der Einheit des Signals (0, solange es keine gibt)</translation>
    </message>
    <message>
        <source>How sharply the limit sets in</source>
        <translation>Wie scharf die Grenze einsetzt</translation>
    </message>
    <message>
        <source>Width of the dead zone on either side of 0 (0: off)</source>
        <translation>Breite der Totzone beiderseits von 0 (0: aus)</translation>
    </message>
    <message>
        <source>Rounding of the corners</source>
        <translation>Abrundung der Ecken</translation>
    </message>
    <message>
        <source>Relative error of the gain (0: off)</source>
        <translation>Relativer Fehler der Verstärkung (0: aus)</translation>
    </message>
    <message>
        <source>Time constant (0: off)</source>
        <translation>Zeitkonstante (0: aus)</translation>
    </message>
    <message>
        <source>Offset (0: off)</source>
        <translation>Versatz (0: aus)</translation>
    </message>
    <message>
        <source>Dead time (0: off)</source>
        <translation>Totzeit (0: aus)</translation>
    </message>
    <message>
        <source>Voltage over which the onset is smoothed</source>
        <translation>Spannung, über die das Einsetzen geglättet wird</translation>
    </message>
    <message>
        <source>Resistance whose heat is lost elsewhere (0: off)</source>
        <translation>Widerstand, dessen Wärme anderswo verloren geht (0: aus)</translation>
    </message>
    <message>
        <source>Coefficient (0: off)</source>
        <translation>Koeffizient (0: aus)</translation>
    </message>
    <message>
        <source>Largest current (0 while off)</source>
        <translation>Größter Strom (0, solange aus)</translation>
    </message>
    <message>
        <source>Recorded channel</source>
        <translation>Aufgezeichneter Kanal</translation>
    </message>
    <message>
        <source>Factor (0: off)</source>
        <translation>Faktor (0: aus)</translation>
    </message>
    <message>
        <source>Torque constant at the present angle</source>
        <translation>Drehmomentkonstante beim augenblicklichen Winkel</translation>
    </message>
    <message>
        <source>Stiffness of the stop (0: off)</source>
        <translation>Steifigkeit des Anschlags (0: aus)</translation>
    </message>
    <message>
        <source>Angle at rest</source>
        <translation>Winkel in Ruhe</translation>
    </message>
    <message>
        <source>Angle where it touches</source>
        <translation>Winkel, bei dem er berührt</translation>
    </message>
    <message>
        <source>Damping of the touch, of its stiffness</source>
        <translation>Dämpfung der Berührung, bezogen auf deren Steifigkeit</translation>
    </message>
    <message>
        <source>Heat flow for that while (0: off)</source>
        <translation>Wärmestrom während dieser Zeit (0: aus)</translation>
    </message>
    <message>
        <source>Torque for that while (0: off)</source>
        <translation>Drehmoment während dieser Zeit (0: aus)</translation>
    </message>
    <message>
        <source>When it sets in</source>
        <translation>Wann er einsetzt</translation>
    </message>
    <message>
        <source>How long it lasts</source>
        <translation>Wie lange er dauert</translation>
    </message>
    <message>
        <source>Width of its edges</source>
        <translation>Breite der Flanken</translation>
    </message>
    <message>
        <source>Conductance beyond (0: off)</source>
        <translation>Leitwert darüber (0: aus)</translation>
    </message>
    <message>
        <source>Temperature where it sets in</source>
        <translation>Temperatur, bei der er einsetzt</translation>
    </message>
    <message>
        <source>Rounding of the onset</source>
        <translation>Rundung des Einsatzes</translation>
    </message>
    <message>
        <source>Rounding of the touch</source>
        <translation>Abrundung der Berührung</translation>
    </message>
    <message>
        <source>Torque from then on (0: off)</source>
        <translation>Drehmoment von da an (0: aus)</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Wann</translation>
    </message>
    <message>
        <source>Width of the step</source>
        <translation>Breite des Sprungs</translation>
    </message>
    <message>
        <source>Half the difference of the two coefficients (0: off)</source>
        <translation>Halbe Differenz der beiden Koeffizienten (0: aus)</translation>
    </message>
    <message>
        <source>Rounding at rest</source>
        <translation>Abrundung in Ruhe</translation>
    </message>
    <message>
        <source>Sine part (0: off)</source>
        <translation>Sinusanteil (0: aus)</translation>
    </message>
    <message>
        <source>Cosine part</source>
        <translation>Kosinusanteil</translation>
    </message>
    <message>
        <source>Relative change of the conductance for each kelvin of its mean temperature (0: off)</source>
        <translation>Relative Änderung des Leitwerts je Kelvin seiner mittleren Temperatur (0: aus)</translation>
    </message>
    <message>
        <source>Mean temperature at which the conductance is G</source>
        <translation>Mittlere Temperatur, bei der der Leitwert G ist</translation>
    </message>
    <message>
        <source>Difference at which the conductance is G</source>
        <translation>Differenz, bei der der Leitwert G ist</translation>
    </message>
    <message>
        <source>Period</source>
        <translation>Periode</translation>
    </message>
    <message>
        <source>Voltage that is left for the current</source>
        <translation>Spannung, die für den Strom übrig bleibt</translation>
    </message>
    <message>
        <source>Offset from then on (0: off)</source>
        <translation>Versatz von da an (0: aus)</translation>
    </message>
    <message>
        <source>Heat flow from then on (0: off)</source>
        <translation>Wärmestrom von da an (0: aus)</translation>
    </message>
    <message>
        <source>Rounding of the corner</source>
        <translation>Abrundung der Ecke</translation>
    </message>
    <message>
        <source>How far beyond the limit</source>
        <translation>Wie weit jenseits der Grenze</translation>
    </message>
    <message>
        <source>Torque constant at the present current</source>
        <translation>Drehmomentkonstante beim augenblicklichen Strom</translation>
    </message>
    <message>
        <source>Torque once it has built up (0: off)</source>
        <translation>Drehmoment, sobald es aufgebaut ist (0: aus)</translation>
    </message>
    <message>
        <source>Travel over which it builds up</source>
        <translation>Weg, über den es sich aufbaut</translation>
    </message>
    <message>
        <source>Share that has built up</source>
        <translation>Anteil, der aufgebaut ist</translation>
    </message>
    <message>
        <source>Shaft that is observed</source>
        <translation>Beobachtete Welle</translation>
    </message>
    <message>
        <source>Torque from flange_a to flange_b</source>
        <translation>Drehmoment von flange_a nach flange_b</translation>
    </message>
    <message>
        <source>Place that is observed</source>
        <translation>Beobachteter Ort</translation>
    </message>
    <message>
        <source>Radiation to constant surroundings</source>
        <translation>Strahlung an eine Umgebung fester Temperatur</translation>
    </message>
    <message>
        <source>Thermal contact resistance</source>
        <translation>Thermischer Kontaktwiderstand</translation>
    </message>
    <message>
        <source>Second mass behind a conductance</source>
        <translation>Zweite Masse hinter einem Wärmeleitwert</translation>
    </message>
    <message>
        <source>Heat loss to constant surroundings</source>
        <translation>Wärmeverlust an eine Umgebung fester Temperatur</translation>
    </message>
    <message>
        <source>Heat loss to constant surroundings of unknown temperature</source>
        <translation>Wärmeverlust an eine Umgebung fester, unbekannter Temperatur</translation>
    </message>
    <message>
        <source>Heat loss to surroundings whose temperature was recorded</source>
        <translation>Wärmeverlust an eine Umgebung, deren Temperatur aufgezeichnet wurde</translation>
    </message>
    <message>
        <source>Radiation to constant surroundings of unknown temperature</source>
        <translation>Strahlung an eine Umgebung fester, unbekannter Temperatur</translation>
    </message>
    <message>
        <source>Radiation to surroundings whose temperature was recorded</source>
        <translation>Strahlung an eine Umgebung, deren Temperatur aufgezeichnet wurde</translation>
    </message>
    <message>
        <source>Torque that was recorded but not given to the model</source>
        <translation>Drehmoment, das aufgezeichnet, aber dem Modell nicht gegeben wurde</translation>
    </message>
    <message>
        <source>Heat flow that was recorded but not given to the model</source>
        <translation>Wärmestrom, der aufgezeichnet, aber dem Modell nicht gegeben wurde</translation>
    </message>
    <message>
        <source>Heat of evaporation taken up once</source>
        <translation>Einmal aufgenommene Verdampfungswärme</translation>
    </message>
    <message>
        <source>Warming of the magnets, which takes torque constant</source>
        <translation>Erwärmung der Magnete, die Drehmomentkonstante kostet</translation>
    </message>
    <message>
        <source>Voltage drop of brushes or diodes</source>
        <translation>Spannungsabfall an Bürsten oder Dioden</translation>
    </message>
    <message>
        <source>Torque constant that follows a temperature of the model</source>
        <translation>Temperaturabhängige Drehmomentkonstante</translation>
    </message>
    <message>
        <source>Lead or contact resistance in series with the winding</source>
        <translation>Zuleitungs- oder Kontaktwiderstand in Reihe zur Wicklung</translation>
    </message>
    <message>
        <source>Leads, brushes and a saturating inductance at once</source>
        <translation>Zuleitung, Bürsten und sättigende Induktivität zugleich</translation>
    </message>
    <message>
        <source>Electric machine with several effects, a warm winding among them</source>
        <translation>Elektrische Maschine mit mehreren Effekten, darunter eine warme Wicklung</translation>
    </message>
    <message>
        <source>Electric machine with several effects, warm magnets among them</source>
        <translation>Elektrische Maschine mit mehreren Effekten, darunter warme Magnete</translation>
    </message>
    <message>
        <source>Electric machine with several effects, the temperature of a node among their causes</source>
        <translation>Elektrische Maschine mit mehreren Effekten, darunter die Temperatur eines Knotens als Ursache</translation>
    </message>
    <message>
        <source>Heater with leads and the drop of a switch</source>
        <translation>Heizer mit Zuleitung und Spannungsabfall eines Schalters</translation>
    </message>
    <message>
        <source>Warming of the winding, which gains resistance</source>
        <translation>Erwärmung der Wicklung, deren Widerstand steigt</translation>
    </message>
    <message>
        <source>Saturation of the inductance with the current</source>
        <translation>Sättigung der Induktivität mit dem Strom</translation>
    </message>
    <message>
        <source>Resistance that follows a temperature of the model</source>
        <translation>Temperaturabhängiger Widerstand</translation>
    </message>
    <message>
        <source>Dry friction</source>
        <translation>Trockene Reibung</translation>
    </message>
    <message>
        <source>Torque of an unbalanced mass: once per turn</source>
        <translation>Drehmoment einer Unwucht: einmal je Umdrehung</translation>
    </message>
    <message>
        <source>Torque that repeats n times per turn</source>
        <translation>n-mal je Umdrehung wiederkehrendes Drehmoment</translation>
    </message>
    <message>
        <source>Torque proportional to the square of the speed</source>
        <translation>Drehmoment mit dem Quadrat der Drehzahl</translation>
    </message>
    <message>
        <source>Play in the gear</source>
        <translation>Spiel im Getriebe</translation>
    </message>
    <message>
        <source>Constant load torque</source>
        <translation>Konstantes Lastmoment</translation>
    </message>
    <message>
        <source>Dry friction with extra breakaway torque that falls off with speed</source>
        <translation>Trockene Reibung mit drehzahlabhängigem Losbrechmoment</translation>
    </message>
    <message>
        <source>Further inertia on the shaft</source>
        <translation>Weitere Trägheit auf der Welle</translation>
    </message>
    <message>
        <source>Torque proportional to the speed</source>
        <translation>Drehmoment proportional zur Drehzahl</translation>
    </message>
    <message>
        <source>Spring to the housing</source>
        <translation>Feder zum Gehäuse</translation>
    </message>
    <message>
        <source>Shaft that twists</source>
        <translation>Nachgiebige Welle</translation>
    </message>
    <message>
        <source>Offset of a measured channel</source>
        <translation>Nullpunktfehler eines Messkanals</translation>
    </message>
    <message>
        <source>Lag of a measured channel</source>
        <translation>Trägheit eines Messkanals</translation>
    </message>
    <message>
        <source>Gain error of a thermometer that is right at 0 degC</source>
        <translation>Verstärkungsfehler eines Thermometers, das bei 0 °C richtig geht</translation>
    </message>
    <message>
        <source>Gain error of a commanded or recorded temperature that is right at 0 degC</source>
        <translation>Verstärkungsfehler einer vorgegebenen oder aufgezeichneten Temperatur, die bei 0 °C richtig ist</translation>
    </message>
    <message>
        <source>A temperature that is off by a factor, counted from 0 degC</source>
        <translation>Eine Temperatur, die um einen Faktor danebenliegt, von 0 °C an gerechnet</translation>
    </message>
    <message>
        <source>An error of a thermometer: inserted in front of a measured temperature.</source>
        <translation>Ein Fehler eines Thermometers: vor einer gemessenen Temperatur eingefügt.</translation>
    </message>
    <message>
        <source>An error of what sets or records a temperature that drives the model: inserted behind an input.</source>
        <translation>Ein Fehler dessen, was eine treibende Temperatur einstellt oder aufzeichnet: hinter einem Eingang eingefügt.</translation>
    </message>
    <message>
        <source>Shared by the effects of sensors and actuators. A thermometer is adjusted in ice water and amplifies what it reads in degrees Celsius, so that its error vanishes there and not at 0 K.</source>
        <translation>Den Effekten von Sensoren und Stellgliedern gemeinsam. Ein Thermometer wird in Eiswasser abgeglichen und verstärkt, was es in Grad Celsius liest; sein Fehler verschwindet also dort und nicht bei 0 K.</translation>
    </message>
    <message>
        <source>Gain error of a measured channel</source>
        <translation>Verstärkungsfehler eines Messkanals</translation>
    </message>
    <message>
        <source>Dead time of a measured channel</source>
        <translation>Totzeit eines Messkanals</translation>
    </message>
    <message>
        <source>Drift of a measured channel</source>
        <translation>Drift eines Messkanals</translation>
    </message>
    <message>
        <source>Convection that depends on a recorded flow</source>
        <translation>Konvektion abhängig von einer gemessenen Strömung</translation>
    </message>
    <message>
        <source>Convection in a measured stream that depends on a second recorded flow</source>
        <translation>Konvektion in gemessener Strömung, die von einem zweiten gemessenen Durchfluss abhängt</translation>
    </message>
    <message>
        <source>Convection that depends on the temperature difference</source>
        <translation>Konvektion abhängig von der Temperaturdifferenz</translation>
    </message>
    <message>
        <source>Offset of an input channel</source>
        <translation>Nullpunktfehler eines Eingangskanals</translation>
    </message>
    <message>
        <source>Lag of an input channel</source>
        <translation>Trägheit eines Eingangskanals</translation>
    </message>
    <message>
        <source>Gain error of an input channel</source>
        <translation>Verstärkungsfehler eines Eingangskanals</translation>
    </message>
    <message>
        <source>Dead time of an input channel</source>
        <translation>Totzeit eines Eingangskanals</translation>
    </message>
    <message>
        <source>Limit of an input channel</source>
        <translation>Begrenzung eines Eingangskanals</translation>
    </message>
    <message>
        <source>Dead zone of an input channel</source>
        <translation>Totzone eines Eingangskanals</translation>
    </message>
    <message>
        <source>Voltage drop of a switch or contact</source>
        <translation>Spannungsabfall eines Schalters oder Kontakts</translation>
    </message>
    <message>
        <source>Lead or contact resistance whose heat is lost elsewhere</source>
        <translation>Zuleitungs- oder Kontaktwiderstand mit Wärmeabgabe an anderer Stelle</translation>
    </message>
    <message>
        <source>Torque constant that falls with the current</source>
        <translation>Drehmomentkonstante, die mit dem Strom sinkt</translation>
    </message>
    <message>
        <source>Torque of any course that repeats with every turn</source>
        <translation>Drehmoment beliebigen Verlaufs, das mit jeder Umdrehung wiederkehrt</translation>
    </message>
    <message>
        <source>Once per turn, with the sine of the angle (0: off)</source>
        <translation>Einmal je Umdrehung, mit dem Sinus des Winkels (0: aus)</translation>
    </message>
    <message>
        <source>Once per turn, with the cosine</source>
        <translation>Einmal je Umdrehung, mit dem Kosinus</translation>
    </message>
    <message>
        <source>Twice per turn, with the sine</source>
        <translation>Zweimal je Umdrehung, mit dem Sinus</translation>
    </message>
    <message>
        <source>Twice per turn, with the cosine</source>
        <translation>Zweimal je Umdrehung, mit dem Kosinus</translation>
    </message>
    <message>
        <source>Three times per turn, with the sine</source>
        <translation>Dreimal je Umdrehung, mit dem Sinus</translation>
    </message>
    <message>
        <source>Three times per turn, with the cosine</source>
        <translation>Dreimal je Umdrehung, mit dem Kosinus</translation>
    </message>
    <message>
        <source>Torque constant that changes with the angle</source>
        <translation>Drehmomentkonstante, die sich mit dem Winkel ändert</translation>
    </message>
    <message>
        <source>1/i_s^2: at the current i_s the torque constant is down to 0.71 (0: off)</source>
        <translation>1/i_s^2: beim Strom i_s ist die Drehmomentkonstante auf 0,71 gesunken (0: aus)</translation>
    </message>
    <message>
        <source>Relative change per angle (0: off)</source>
        <translation>Relative Änderung je Winkel (0: aus)</translation>
    </message>
    <message>
        <source>Relative change per square of the angle</source>
        <translation>Relative Änderung je Quadrat des Winkels</translation>
    </message>
    <message>
        <source>Driver that limits the current</source>
        <translation>Treiber, der den Strom begrenzt</translation>
    </message>
    <message>
        <source>Contact whose resistance falls with the current</source>
        <translation>Kontakt, dessen Widerstand mit dem Strom fällt</translation>
    </message>
    <message>
        <source>Contact before a heater whose resistance falls with the current</source>
        <translation>Kontakt vor einem Heizer, dessen Widerstand mit dem Strom fällt</translation>
    </message>
    <message>
        <source>Resistance at small currents (0: none)</source>
        <translation>Widerstand bei kleinen Strömen (0: keiner)</translation>
    </message>
    <message>
        <source>Current at which half of it is left</source>
        <translation>Strom, bei dem die Hälfte davon bleibt</translation>
    </message>
    <message>
        <source>How steeply it falls</source>
        <translation>Wie steil er fällt</translation>
    </message>
    <message>
        <source>Driver that limits the current of a heater</source>
        <translation>Treiber, der den Strom eines Heizers begrenzt</translation>
    </message>
    <message>
        <source>Driver that limits the power of a heater</source>
        <translation>Treiber, der die Leistung eines Heizers begrenzt</translation>
    </message>
    <message>
        <source>Resistance that is not straight in the temperature</source>
        <translation>Widerstand mit gekrümmtem Temperaturgang</translation>
    </message>
    <message>
        <source>Largest power (0 while off)</source>
        <translation>Größte Leistung (0: aus)</translation>
    </message>
    <message>
        <source>Power at the voltage that is commanded</source>
        <translation>Leistung bei der befohlenen Spannung</translation>
    </message>
    <message>
        <source>Relative change with the square of the temperature above T_ref</source>
        <translation>Relative Änderung mit dem Quadrat der Temperatur über T_ref</translation>
    </message>
    <message>
        <source>Convection that grows with the temperature of the body</source>
        <translation>Konvektion, die mit der Temperatur des Körpers wächst</translation>
    </message>
    <message>
        <source>Relative change of the conductance for each kelvin of the body (0: off)</source>
        <translation>Relative Änderung des Leitwerts je Kelvin des Körpers (0: aus)</translation>
    </message>
    <message>
        <source>Temperature of the body at which the conductance is that without the effect</source>
        <translation>Temperatur des Körpers, bei welcher der Leitwert der ohne den Effekt ist</translation>
    </message>
    <message>
        <source>Torque that grows with the third power of speed</source>
        <translation>Drehmoment mit der dritten Potenz der Drehzahl</translation>
    </message>
    <message>
        <source>Spring that stiffens with its travel</source>
        <translation>Mit dem Weg steifer werdende Feder</translation>
    </message>
    <message>
        <source>End stop at a large angle</source>
        <translation>Anschlag bei großem Winkel</translation>
    </message>
    <message>
        <source>Torque that sets in during the run</source>
        <translation>Im Lauf einsetzendes Drehmoment</translation>
    </message>
    <message>
        <source>Friction that builds up over a travel</source>
        <translation>Über einen Weg sich aufbauende Reibung</translation>
    </message>
    <message>
        <source>Viscous friction that differs with the direction</source>
        <translation>Richtungsabhängige viskose Reibung</translation>
    </message>
    <message>
        <source>Heat flow that repeats in time</source>
        <translation>Periodischer Wärmestrom</translation>
    </message>
    <message>
        <source>Offset that sets in during the run</source>
        <translation>Im Lauf einsetzender Nullpunktfehler</translation>
    </message>
    <message>
        <source>Reading with a hum of its own</source>
        <translation>Anzeige mit eigenem Brummen</translation>
    </message>
    <message>
        <source>Torque that repeats in time</source>
        <translation>Periodisches Drehmoment</translation>
    </message>
    <message>
        <source>End stop at a small angle</source>
        <translation>Anschlag bei kleinem Winkel</translation>
    </message>
    <message>
        <source>Heat flow that acts for a while</source>
        <translation>Zeitweise wirkender Wärmestrom</translation>
    </message>
    <message>
        <source>Torque that acts for a while</source>
        <translation>Zeitweise wirkendes Drehmoment</translation>
    </message>
    <message>
        <source>Loss that sets in above a temperature</source>
        <translation>Oberhalb einer Temperatur einsetzender Verlust</translation>
    </message>
    <message>
        <source>Heat flow that sets in during the run</source>
        <translation>Im Lauf einsetzender Wärmestrom</translation>
    </message>
    <message>
        <source>Upper limit of a measured channel</source>
        <translation>Obere Grenze eines Messkanals</translation>
    </message>
    <message>
        <source>mechanics</source>
        <translation>mechanisch</translation>
    </message>
    <message>
        <source>electric-mechanical</source>
        <translation>elektrisch-mechanisch</translation>
    </message>
    <message>
        <source>electric-thermal</source>
        <translation>elektrisch-thermisch</translation>
    </message>
    <message>
        <source>thermal-fluid</source>
        <translation>thermisch-fluidisch</translation>
    </message>
    <message>
        <source>mechanic-thermal</source>
        <translation>mechanisch-thermisch</translation>
    </message>
    <message>
        <source>Two inertias joined by a gear and an elastic, damped shaft</source>
        <translation>Zwei Trägheiten, verbunden durch Getriebe und elastische, gedämpfte Welle</translation>
    </message>
    <message>
        <source>Direct-current machine with permanent field</source>
        <translation>Permanenterregte Gleichstrommaschine</translation>
    </message>
    <message>
        <source>Heating resistor whose resistance rises with its temperature</source>
        <translation>Heizwiderstand, dessen Widerstand mit der Temperatur steigt</translation>
    </message>
    <message>
        <source>Body with heat capacity in a stream (convection by the fluid temperature)</source>
        <translation>Körper mit Wärmekapazität in einer Strömung (Konvektion nach der Fluidtemperatur)</translation>
    </message>
    <message>
        <source>Body with heat capacity in a stream of measured speed</source>
        <translation>Körper mit Wärmekapazität in einer Strömung gemessener Geschwindigkeit</translation>
    </message>
    <message>
        <source>Bearing with viscous friction that heats</source>
        <translation>Lager mit viskoser Reibung, die heizt</translation>
    </message>
    <message>
        <source>Effects of an input channel</source>
        <translation>Effekte eines Eingangskanals</translation>
    </message>
    <message>
        <source>Extensions of the electric machine</source>
        <translation>Erweiterungen der elektrischen Maschine</translation>
    </message>
    <message>
        <source>Extensions of the heating resistor</source>
        <translation>Erweiterungen des Heizwiderstands</translation>
    </message>
    <message>
        <source>Effects on a shaft</source>
        <translation>Effekte an einer Welle</translation>
    </message>
    <message>
        <source>Equations to propose where no named effect explains what is left</source>
        <translation>Gleichungen als Vorschlag, wo kein benannter Effekt den Rest erklärt</translation>
    </message>
    <message>
        <source>Effects of a measured channel</source>
        <translation>Effekte eines gemessenen Kanals</translation>
    </message>
    <message>
        <source>A signal that comes late by a dead time</source>
        <translation>Ein Signal, das um eine Totzeit später kommt</translation>
    </message>
    <message>
        <source>A signal that is off by a factor</source>
        <translation>Ein Signal, das um einen Faktor abweicht</translation>
    </message>
    <message>
        <source>A signal that lags by one pole</source>
        <translation>Ein Signal, das mit einem Pol nacheilt</translation>
    </message>
    <message>
        <source>A signal that is off by a constant</source>
        <translation>Ein Signal, das um eine Konstante abweicht</translation>
    </message>
    <message>
        <source>Errors of signals, without a place to go</source>
        <translation>Fehler von Signalen, noch ohne Ort</translation>
    </message>
    <message>
        <source>Effects at a place that exchanges heat</source>
        <translation>Effekte an einem Ort, der Wärme austauscht</translation>
    </message>
    <message>
        <source>Extensions of the body in a stream</source>
        <translation>Erweiterungen des Körpers in einer Strömung</translation>
    </message>
    <message>
        <source>Effects that a measurement may show to be missing</source>
        <translation>Effekte, deren Fehlen eine Messung zeigen kann</translation>
    </message>
    <message>
        <source>Connectors and parameters of an electric machine</source>
        <translation>Anschlüsse und Parameter einer elektrischen Maschine</translation>
    </message>
    <message>
        <source>Electrical and mechanical domain: motors</source>
        <translation>Elektrisch-mechanische Domäne: Motoren</translation>
    </message>
    <message>
        <source>Connectors and parameters of a resistor that heats</source>
        <translation>Anschlüsse und Parameter eines Widerstands, der heizt</translation>
    </message>
    <message>
        <source>Electrical and thermal domain: heaters</source>
        <translation>Elektrisch-thermische Domäne: Heizer</translation>
    </message>
    <message>
        <source>Rotational flange (filled: the side that usually drives)</source>
        <translation>Drehflansch (gefüllt: die meist treibende Seite)</translation>
    </message>
    <message>
        <source>Rotational flange (open: the side that is usually driven)</source>
        <translation>Drehflansch (offen: die meist getriebene Seite)</translation>
    </message>
    <message>
        <source>Heat port (filled)</source>
        <translation>Wärmeanschluss (gefüllt)</translation>
    </message>
    <message>
        <source>Heat port (open)</source>
        <translation>Wärmeanschluss (offen)</translation>
    </message>
    <message>
        <source>One flange with its angle and speed</source>
        <translation>Ein Flansch mit Winkel und Drehzahl</translation>
    </message>
    <message>
        <source>One heat port</source>
        <translation>Ein Wärmeanschluss</translation>
    </message>
    <message>
        <source>One signal in, one signal out</source>
        <translation>Ein Signal hinein, ein Signal hinaus</translation>
    </message>
    <message>
        <source>Two flanges</source>
        <translation>Zwei Flansche</translation>
    </message>
    <message>
        <source>Connectors, and the partial classes that share them</source>
        <translation>Anschlüsse und die unvollständigen Klassen, die sie teilen</translation>
    </message>
    <message>
        <source>Shaft whose friction heats a place, without the law of friction</source>
        <translation>Welle, deren Reibung einen Ort heizt, ohne das Reibgesetz</translation>
    </message>
    <message>
        <source>Mechanical and thermal domain: bearings and brakes</source>
        <translation>Mechanisch-thermische Domäne: Lager und Bremsen</translation>
    </message>
    <message>
        <source>Flange held at a fixed angle</source>
        <translation>Flansch, auf festem Winkel gehalten</translation>
    </message>
    <message>
        <source>Rigid body on a shaft</source>
        <translation>Starrer Körper auf einer Welle</translation>
    </message>
    <message>
        <source>Geared shaft with two inertias, without its stiffness</source>
        <translation>Welle mit Getriebe und zwei Trägheiten, ohne ihre Steifigkeit</translation>
    </message>
    <message>
        <source>Load torque with the square of the speed: pump, fan</source>
        <translation>Lastmoment mit dem Quadrat der Drehzahl: Pumpe, Lüfter</translation>
    </message>
    <message>
        <source>Spring between shaft and housing</source>
        <translation>Feder zwischen Welle und Gehäuse</translation>
    </message>
    <message>
        <source>Linear spring and damper in parallel between two flanges</source>
        <translation>Lineare Feder und Dämpfer parallel zwischen zwei Flanschen</translation>
    </message>
    <message>
        <source>Load torque proportional to the speed</source>
        <translation>Lastmoment proportional zur Drehzahl</translation>
    </message>
    <message>
        <source>Rotational mechanics: shafts, gears, inertias and loads</source>
        <translation>Drehmechanik: Wellen, Getriebe, Trägheiten und Lasten</translation>
    </message>
    <message>
        <source>Ideal angle sensor</source>
        <translation>Idealer Winkelsensor</translation>
    </message>
    <message>
        <source>Ideal heat flow sensor between two places</source>
        <translation>Idealer Wärmestromsensor zwischen zwei Orten</translation>
    </message>
    <message>
        <source>Ideal speed sensor</source>
        <translation>Idealer Drehzahlsensor</translation>
    </message>
    <message>
        <source>Ideal temperature sensor</source>
        <translation>Idealer Temperatursensor</translation>
    </message>
    <message>
        <source>Ideal torque sensor between two flanges</source>
        <translation>Idealer Drehmomentsensor zwischen zwei Flanschen</translation>
    </message>
    <message>
        <source>Ideal sensors</source>
        <translation>Ideale Sensoren</translation>
    </message>
    <message>
        <source>First-order lag</source>
        <translation>Verzögerung erster Ordnung</translation>
    </message>
    <message>
        <source>Signal times a constant</source>
        <translation>Signal mal einer Konstanten</translation>
    </message>
    <message>
        <source>Product of two signals</source>
        <translation>Produkt zweier Signale</translation>
    </message>
    <message>
        <source>Sum of two signals</source>
        <translation>Summe zweier Signale</translation>
    </message>
    <message>
        <source>Signal blocks</source>
        <translation>Signalblöcke</translation>
    </message>
    <message>
        <source>A constant signal</source>
        <translation>Ein konstantes Signal</translation>
    </message>
    <message>
        <source>Imposes a constant temperature</source>
        <translation>Gibt eine feste Temperatur vor</translation>
    </message>
    <message>
        <source>Imposes a heat flow given by a signal</source>
        <translation>Gibt einen Wärmestrom nach einem Signal vor</translation>
    </message>
    <message>
        <source>Imposes a temperature given by a signal</source>
        <translation>Gibt eine Temperatur nach einem Signal vor</translation>
    </message>
    <message>
        <source>Imposes a torque given by a signal</source>
        <translation>Gibt ein Drehmoment nach einem Signal vor</translation>
    </message>
    <message>
        <source>Sources: imposed temperatures, flows and signals</source>
        <translation>Quellen: vorgegebene Temperaturen, Ströme und Signale</translation>
    </message>
    <message>
        <source>Straight lines between points</source>
        <translation>Geraden zwischen Punkten</translation>
    </message>
    <message>
        <source>Smooth curve through points, which rises and falls only where they do</source>
        <translation>Glatte Kurve durch Punkte, die nur steigt und fällt, wo diese es tun</translation>
    </message>
    <message>
        <source>Functions given by points</source>
        <translation>Funktionen aus Punkten</translation>
    </message>
    <message>
        <source>Body of uniform temperature</source>
        <translation>Körper einheitlicher Temperatur</translation>
    </message>
    <message>
        <source>Heat conduction between two places</source>
        <translation>Wärmeleitung zwischen zwei Orten</translation>
    </message>
    <message>
        <source>Heat conduction between two places, without its law</source>
        <translation>Wärmeleitung zwischen zwei Stellen, ohne ihr Gesetz</translation>
    </message>
    <message>
        <source>Conduction that changes with its temperature</source>
        <translation>Wärmeleitung, die sich mit ihrer Temperatur ändert</translation>
    </message>
    <message>
        <source>Conduction that changes with the temperature difference</source>
        <translation>Wärmeleitung, die sich mit der Temperaturdifferenz ändert</translation>
    </message>
    <message>
        <source>Convection in a measured stream that depends on the temperature difference</source>
        <translation>Konvektion in gemessener Strömung, die von der Temperaturdifferenz abhängt</translation>
    </message>
    <message>
        <source>Heat storage and conduction</source>
        <translation>Wärmespeicherung und Wärmeleitung</translation>
    </message>
    <message>
        <source>Body with heat capacity in a stream, without its law of convection</source>
        <translation>Körper mit Wärmekapazität in einer Strömung, ohne das Konvektionsgesetz</translation>
    </message>
    <message>
        <source>Thermal and fluid domain: bodies in a stream</source>
        <translation>Thermisch-fluidische Domäne: Körper in einer Strömung</translation>
    </message>
    <message>
        <source>Blocks for physical models of automotive components</source>
        <translation>Blöcke für physikalische Modelle von Fahrzeugbauteilen</translation>
    </message>
    <message>
        <source>A signal that is read</source>
        <translation>Ein Signal, das gelesen wird</translation>
    </message>
    <message>
        <source>A signal that is given out</source>
        <translation>Ein Signal, das ausgegeben wird</translation>
    </message>
    <message>
        <source>An error of an actuator or its driver: inserted behind an input.</source>
        <translation>Ein Fehler eines Stellglieds oder seines Treibers: hinter einem Eingang eingefügt.</translation>
    </message>
    <message>
        <source>Errors of actuators and their drivers, inserted behind an input.</source>
        <translation>Fehler von Stellgliedern und ihren Treibern, hinter einem Eingang eingefügt.</translation>
    </message>
    <message>
        <source>Resistance of leads, drop of brushes, saturation of the inductance, and a resistance and a magnet that follow the temperature of a heat port of the model, in one machine. What is not asked for is off.</source>
        <translation>Widerstand der Leitungen, Bürstenspannung, Sättigung der Induktivität sowie ein Widerstand und ein Magnet, die der Temperatur eines Wärmeanschlusses des Modells folgen, in einer Maschine. Was nicht verlangt wird, ist aus.</translation>
    </message>
    <message>
        <source>Resistance of leads, drop of brushes, saturation of the inductance and magnets that the loss of the winding warms, in one machine. What is not asked for is off.</source>
        <translation>Widerstand der Leitungen, Bürstenspannung, Sättigung der Induktivität und Magnete, die der Verlust der Wicklung erwärmt, in einer Maschine. Was nicht verlangt wird, ist aus.</translation>
    </message>
    <message>
        <source>Resistance of leads, drop of brushes, saturation of the inductance and a winding that its loss warms, in one machine. What is not asked for is off.</source>
        <translation>Widerstand der Leitungen, Bürstenspannung, Sättigung der Induktivität und eine Wicklung, die ihr Verlust erwärmt, in einer Maschine. Was nicht verlangt wird, ist aus.</translation>
    </message>
    <message>
        <source>BasicElectricMechanical whose magnet weakens with the temperature of a heat port that the model already has.</source>
        <translation>BasicElectricMechanical, dessen Magnet mit der Temperatur eines Wärmeanschlusses schwächer wird, den das Modell schon hat.</translation>
    </message>
    <message>
        <source>BasicElectricMechanical with magnets that weaken as the loss of the winding warms them. Only beta/C_m shows, so beta keeps a typical value and e_m = 1/C_m is the strength.</source>
        <translation>BasicElectricMechanical mit Magneten, die schwächer werden, wenn der Verlust der Wicklung sie erwärmt. Nur beta/C_m zeigt sich, also behält beta einen üblichen Wert, und e_m = 1/C_m ist die Stärke.</translation>
    </message>
    <message>
        <source>BasicElectricMechanical with an iron path that saturates.</source>
        <translation>BasicElectricMechanical mit einem Eisenweg, der sättigt.</translation>
    </message>
    <message>
        <source>Base of the electric machines with several effects at once. A class that extends it says what the resistance of the winding and the torque constant are.</source>
        <translation>Basis der elektrischen Maschinen mit mehreren Effekten zugleich. Eine Klasse, die sie erweitert, sagt, was der Widerstand der Wicklung und die Drehmomentkonstante sind.</translation>
    </message>
    <message>
        <source>BasicElectricMechanical whose resistance follows the temperature of a heat port that the model already has: a winding with its own heat balance.</source>
        <translation>BasicElectricMechanical, dessen Widerstand der Temperatur eines Wärmeanschlusses folgt, den das Modell schon hat: eine Wicklung mit eigener Wärmebilanz.</translation>
    </message>
    <message>
        <source>BasicElectricMechanical with the resistance of leads, contacts or the supply in series.</source>
        <translation>BasicElectricMechanical mit dem Widerstand von Leitungen, Kontakten oder der Versorgung in Reihe.</translation>
    </message>
    <message>
        <source>BasicElectricMechanical with a constant drop against the current. While the voltage cannot overcome it the current stays at 0.</source>
        <translation>BasicElectricMechanical mit einem konstanten Spannungsabfall gegen den Strom. Solange die Spannung ihn nicht überwindet, bleibt der Strom bei 0.</translation>
    </message>
    <message>
        <source>The change of sign is smoothed over the small current i_eps.</source>
        <translation>Der Vorzeichenwechsel wird über den kleinen Strom i_eps geglättet.</translation>
    </message>
    <message>
        <source>BasicElectricMechanical with a winding that is heated by its own loss. Only alpha/C_w and C_w/G_w show in current and speed, so alpha keeps the value of copper, and heat capacity and conductance are given by e_w and tau_w: C_w = 1/e_w, G_w = C_w/tau_w.</source>
        <translation>BasicElectricMechanical mit einer Wicklung, die ihr eigener Verlust erwärmt. Nur alpha/C_w und C_w/G_w zeigen sich in Strom und Drehzahl, also behält alpha den Wert von Kupfer, und Wärmekapazität und Leitwert folgen aus e_w und tau_w: C_w = 1/e_w, G_w = C_w/tau_w.</translation>
    </message>
    <message>
        <source>Classes that replace BasicElectricMechanical: they extend the same base and take the same parameters.</source>
        <translation>Klassen, die BasicElectricMechanical ersetzen: Sie erweitern dieselbe Basis und haben dieselben Parameter.</translation>
    </message>
    <message>
        <source>BasicElectricThermal behind a switch or contact with a constant drop and the resistance of leads, contacts or the supply; only the heat of R_T goes to the heat port.</source>
        <translation>BasicElectricThermal hinter einem Schalter oder Kontakt mit konstantem Spannungsabfall und dem Widerstand von Leitungen, Kontakten oder der Versorgung; nur die Wärme von R_T geht an den Wärmeanschluss.</translation>
    </message>
    <message>
        <source>The corners are rounded over v_eps.</source>
        <translation>Die Ecken werden über v_eps abgerundet.</translation>
    </message>
    <message>
        <source>BasicElectricThermal with the resistance of leads, contacts or the supply in series; only the heat of R_T goes to the heat port.</source>
        <translation>BasicElectricThermal mit dem Widerstand von Leitungen, Kontakten oder der Versorgung in Reihe; nur die Wärme von R_T geht an den Wärmeanschluss.</translation>
    </message>
    <message>
        <source>BasicElectricThermal behind a switch or contact with a constant drop. No current flows while the voltage is below the drop.</source>
        <translation>BasicElectricThermal hinter einem Schalter oder Kontakt mit konstantem Spannungsabfall. Es fließt kein Strom, solange die Spannung unter dem Abfall liegt.</translation>
    </message>
    <message>
        <source>Classes that replace BasicElectricThermal: they extend the same base and take the same parameters.</source>
        <translation>Klassen, die BasicElectricThermal ersetzen: Sie erweitern dieselbe Basis und haben dieselben Parameter.</translation>
    </message>
    <message>
        <source>An inertia that turns with the shaft.</source>
        <translation>Eine Trägheit, die sich mit der Welle dreht.</translation>
    </message>
    <message>
        <source>Two toothed wheels that touch on one side only: within the play of width b no torque is passed on, beyond it the teeth are elastic and damped. Without play the connection is rigid.</source>
        <translation>Zwei Zahnräder, die sich nur auf einer Seite berühren: Im Spiel der Breite b wird kein Drehmoment weitergegeben, jenseits davon sind die Zähne elastisch und gedämpft. Ohne Spiel ist die Verbindung starr.</translation>
    </message>
    <message>
        <source>The corners are rounded over phi_eps. The equation is multiplied by b, so that b = 0 leaves phi_rel = 0, the rigid shaft; a stiffness of less than c/1e9 keeps the play from drifting.</source>
        <translation>Die Ecken werden über phi_eps abgerundet. Die Gleichung ist mit b multipliziert, so dass b = 0 phi_rel = 0 lässt, die starre Welle; eine Steifigkeit von weniger als c/1e9 hält das Spiel vom Wandern ab.</translation>
    </message>
    <message>
        <source>The pull of the slots of a motor with permanent magnets, or the teeth of a gear.</source>
        <translation>Der Zug der Nuten eines Motors mit Permanentmagneten oder die Zähne eines Getriebes.</translation>
    </message>
    <message>
        <source>A weight on a drum, a preload: the same torque at every angle and speed.</source>
        <translation>Ein Gewicht an einer Trommel, eine Vorspannung: dasselbe Drehmoment bei jedem Winkel und jeder Drehzahl.</translation>
    </message>
    <message>
        <source>A constant drop against the current. While the voltage cannot overcome it the current stays at 0.</source>
        <translation>Ein konstanter Abfall gegen den Strom. Solange die Spannung ihn nicht überwindet, bleibt der Strom bei 0.</translation>
    </message>
    <message>
        <source>Isolation that is not perfect, a bleeder, a filter: current that flows to ground beside the load.</source>
        <translation>Eine unvollkommene Isolation, ein Entladewiderstand, ein Filter: Strom, der neben der Last nach Masse fließt.</translation>
    </message>
    <message>
        <source>What may lie in a wire, and what may flow beside the load.</source>
        <translation>Was in einer Leitung liegen und was neben der Last fließen kann.</translation>
    </message>
    <message>
        <source>Lead, contact or inner resistance of the supply, where the model had an ideal wire. Its heat is lost.</source>
        <translation>Zuleitung, Kontakt oder Innenwiderstand der Versorgung, wo das Modell eine ideale Leitung hatte. Seine Wärme geht verloren.</translation>
    </message>
    <message>
        <source>Isolation between two wires that is not perfect.</source>
        <translation>Eine unvollkommene Isolation zwischen zwei Leitungen.</translation>
    </message>
    <message>
        <source>A long cable, a filter: charge that the wire must take up before its potential rises.</source>
        <translation>Ein langes Kabel, ein Filter: Ladung, die die Leitung aufnehmen muss, bevor ihr Potential steigt.</translation>
    </message>
    <message>
        <source>A loop of wire that the current must build its field in.</source>
        <translation>Eine Leiterschleife, in der der Strom sein Feld aufbauen muss.</translation>
    </message>
    <message>
        <source>A constant force against the motion.</source>
        <translation>Eine konstante Kraft gegen die Bewegung.</translation>
    </message>
    <message>
        <source>The jump at standstill is smoothed over the small velocity v_eps, so that the force has a slope everywhere: a stuck rod creeps at a fraction of v_eps.</source>
        <translation>Der Sprung im Stillstand ist über die kleine Geschwindigkeit v_eps geglättet, damit die Kraft überall eine Steigung hat: eine haftende Stange kriecht mit einem Bruchteil von v_eps.</translation>
    </message>
    <message>
        <source>Friction, drag, loads, springs and masses attached to a rod, and what may lie between two rods.</source>
        <translation>Reibung, Widerstand, Lasten, Federn und Massen an einer Stange, und was zwischen zwei Stangen liegen kann.</translation>
    </message>
    <message>
        <source>A weight, a preload: the same force at every position and velocity.</source>
        <translation>Ein Gewicht, eine Vorspannung: dieselbe Kraft bei jeder Position und Geschwindigkeit.</translation>
    </message>
    <message>
        <source>Drag of a body that moves in air or liquid, or throttling.</source>
        <translation>Widerstand eines Körpers, der sich in Luft oder Flüssigkeit bewegt, oder Drosselung.</translation>
    </message>
    <message>
        <source>A fork that holds a pin with play, a nut on a spindle: within the play of width b no force is passed on, beyond it the contact is elastic and damped. Without play the connection is rigid.</source>
        <translation>Eine Gabel, die einen Bolzen mit Spiel hält, eine Mutter auf einer Spindel: innerhalb des Spiels der Breite b wird keine Kraft weitergegeben, darüber hinaus ist der Kontakt elastisch und gedämpft. Ohne Spiel ist die Verbindung starr.</translation>
    </message>
    <message>
        <source>The corners are rounded over s_eps. The equation is multiplied by b, so that b = 0 leaves s_rel = 0, the rigid rod; a stiffness of less than c/1e9 keeps the play from drifting.</source>
        <translation>Die Ecken sind über s_eps gerundet. Die Gleichung ist mit b multipliziert, damit b = 0 nur s_rel = 0 lässt, die starre Stange; eine Steifigkeit von weniger als c/1e9 hält das Spiel vom Abdriften ab.</translation>
    </message>
    <message>
        <source>A mass that moves with the rod.</source>
        <translation>Eine Masse, die sich mit der Stange bewegt.</translation>
    </message>
    <message>
        <source>A spring between rod and housing.</source>
        <translation>Eine Feder zwischen Stange und Gehäuse.</translation>
    </message>
    <message>
        <source>An elastic, damped rod where the model had a rigid one. The strength is the compliance e = 1/c, so that 0 is the rigid rod.</source>
        <translation>Eine elastische, gedämpfte Stange, wo das Modell eine starre hatte. Die Stärke ist die Nachgiebigkeit e = 1/c, sodass 0 die starre Stange ist.</translation>
    </message>
    <message>
        <source>A coil without resistance or saturation.</source>
        <translation>Eine Spule ohne Widerstand und Sättigung.</translation>
    </message>
    <message>
        <source>A resistor at a constant temperature.</source>
        <translation>Ein Widerstand bei konstanter Temperatur.</translation>
    </message>
    <message>
        <source>Components between pins, and the conversion that joins a circuit to a shaft. A pin carries the potential v and the flow i, as in the Modelica Standard Library; every circuit needs a ground.</source>
        <translation>Bauteile zwischen Anschlüssen, und die Wandlung, die einen Stromkreis mit einer Welle verbindet. Ein Anschluss trägt das Potential v und den Fluss i, wie in der Modelica Standard Library; jeder Stromkreis braucht eine Masse.</translation>
    </message>
    <message>
        <source>The ideal part of a direct-current machine; resistance, inductance and inertia are blocks of their own. The housing takes the reaction.</source>
        <translation>Der ideale Teil einer Gleichstrommaschine; Widerstand, Induktivität und Trägheit sind eigene Blöcke. Das Gehäuse nimmt die Gegenwirkung auf.</translation>
    </message>
    <message>
        <source>A switch, a transistor driven hard: closed where the signal is above 0.5.</source>
        <translation>Ein Schalter, ein voll durchgesteuerter Transistor: geschlossen, wo das Signal über 0,5 liegt.</translation>
    </message>
    <message>
        <source>A capacitor.</source>
        <translation>Ein Kondensator.</translation>
    </message>
    <message>
        <source>Conducts from p to n. The characteristic has a slope everywhere, so that its parameters can be fitted.</source>
        <translation>Leitet von p nach n. Die Kennlinie hat überall eine Steigung, damit ihre Parameter angepasst werden können.</translation>
    </message>
    <message>
        <source>Beyond v = 40*V_t the exponential goes on as its tangent.</source>
        <translation>Oberhalb von v = 40*V_t läuft die Exponentialfunktion als ihre Tangente weiter.</translation>
    </message>
    <message>
        <source>Every circuit needs one: potentials are counted from here.</source>
        <translation>Jeder Stromkreis braucht eine: Potentiale zählen von hier.</translation>
    </message>
    <message>
        <source>One end of a wire: the potential v is the same for all that is connected, the currents i into the components sum to zero.</source>
        <translation>Ein Ende einer Leitung: das Potential v ist für alles Verbundene gleich, die Ströme i in die Bauteile ergeben in der Summe null.</translation>
    </message>
    <message>
        <source>Base of effects between a wire and ground. A class that extends it adds one equation for pin.i.</source>
        <translation>Basis von Effekten zwischen einer Leitung und Masse. Eine Klasse, die sie erweitert, fügt eine Gleichung für pin.i hinzu.</translation>
    </message>
    <message>
        <source>Base of effects that act on a rod. A class that extends it adds one equation for flange.f.</source>
        <translation>Basis von Effekten, die auf eine Stange wirken. Eine Klasse, die sie erweitert, fügt eine Gleichung für flange.f hinzu.</translation>
    </message>
    <message>
        <source>Base of components between two pins. A class that extends it adds one equation for voltage and current.</source>
        <translation>Basis von Bauteilen zwischen zwei Anschlüssen. Eine Klasse, die sie erweitert, fügt eine Gleichung für Spannung und Strom hinzu.</translation>
    </message>
    <message>
        <source>Base of components between two translational flanges. A class that extends it adds two equations for positions and forces.</source>
        <translation>Basis von Bauteilen zwischen zwei translatorischen Flanschen. Eine Klasse, die sie erweitert, fügt zwei Gleichungen für Positionen und Kräfte hinzu.</translation>
    </message>
    <message>
        <source>One end of a rod: the position s is the same for all that is connected, the forces f into the components sum to zero.</source>
        <translation>Ein Ende einer Stange: die Position s ist für alles Verbundene gleich, die Kräfte f in die Bauteile ergeben in der Summe null.</translation>
    </message>
    <message>
        <source>Passes the current on without a drop and tells it.</source>
        <translation>Gibt den Strom ohne Abfall weiter und meldet ihn.</translation>
    </message>
    <message>
        <source>Passes position and force on unchanged and tells the force.</source>
        <translation>Gibt Position und Kraft unverändert weiter und meldet die Kraft.</translation>
    </message>
    <message>
        <source>Reads the position of a flange and takes no force.</source>
        <translation>Liest die Position eines Flansches und nimmt keine Kraft auf.</translation>
    </message>
    <message>
        <source>Reads the velocity of a flange and takes no force.</source>
        <translation>Liest die Geschwindigkeit eines Flansches und nimmt keine Kraft auf.</translation>
    </message>
    <message>
        <source>Reads the voltage between two wires and takes no current.</source>
        <translation>Liest die Spannung zwischen zwei Leitungen und nimmt keinen Strom auf.</translation>
    </message>
    <message>
        <source>An ideal source of current: i at any voltage, from p to n through the source.</source>
        <translation>Eine ideale Stromquelle: i bei jeder Spannung, von p nach n durch die Quelle.</translation>
    </message>
    <message>
        <source>Drives the rod with the force f, at any velocity; the housing takes the reaction.</source>
        <translation>Treibt die Stange mit der Kraft f bei jeder Geschwindigkeit; das Gehäuse nimmt die Gegenwirkung auf.</translation>
    </message>
    <message>
        <source>An ideal supply: the voltage v at any current.</source>
        <translation>Eine ideale Versorgung: die Spannung v bei jedem Strom.</translation>
    </message>
    <message>
        <source>Components on a rod, and the rack that joins it to a shaft. The flange carries the position s and the flow f, as in the Modelica Standard Library.</source>
        <translation>Bauteile an einer Stange, und die Zahnstange, die sie mit einer Welle verbindet. Der Flansch trägt die Position s und den Fluss f, wie in der Modelica Standard Library.</translation>
    </message>
    <message>
        <source>Joins a shaft and a rod without mass, loss or play.</source>
        <translation>Verbindet eine Welle und eine Stange ohne Masse, Verlust und Spiel.</translation>
    </message>
    <message>
        <source>A massless elastic and damped rod.</source>
        <translation>Eine masselose, elastische und gedämpfte Stange.</translation>
    </message>
    <message>
        <source>A mass on a rigid rod; both flanges are the same place.</source>
        <translation>Eine Masse an einer starren Stange; beide Flansche sind derselbe Ort.</translation>
    </message>
    <message>
        <source>The housing: the flange does not move.</source>
        <translation>Das Gehäuse: der Flansch bewegt sich nicht.</translation>
    </message>
    <message>
        <source>A constant torque against the motion.</source>
        <translation>Ein konstantes Drehmoment gegen die Bewegung.</translation>
    </message>
    <message>
        <source>The jump at standstill is smoothed over the small speed w_eps, so that the torque has a slope everywhere: a stuck shaft creeps at a fraction of w_eps.</source>
        <translation>Der Sprung im Stillstand wird über die kleine Drehzahl w_eps geglättet, damit das Drehmoment überall eine Steigung hat: Eine haftende Welle kriecht mit einem Bruchteil von w_eps.</translation>
    </message>
    <message>
        <source>An elastic, damped shaft where the model had a rigid one. The strength is the compliance e = 1/c, so that 0 is the rigid shaft.</source>
        <translation>Eine elastische, gedämpfte Welle, wo das Modell eine starre hatte. Die Stärke ist die Nachgiebigkeit e = 1/c, so dass 0 die starre Welle ist.</translation>
    </message>
    <message>
        <source>The weight of an arm, a flap or an eccentric on a horizontal shaft.</source>
        <translation>Das Gewicht eines Arms, einer Klappe oder eines Exzenters an einer waagrechten Welle.</translation>
    </message>
    <message>
        <source>Drag of a body that turns in air or liquid.</source>
        <translation>Widerstand eines Körpers, der sich in Luft oder Flüssigkeit dreht.</translation>
    </message>
    <message>
        <source>A spring between shaft and housing.</source>
        <translation>Eine Feder zwischen Welle und Gehäuse.</translation>
    </message>
    <message>
        <source>Dry friction that is higher at breakaway than at speed.</source>
        <translation>Trockene Reibung, die beim Losbrechen höher ist als in Fahrt.</translation>
    </message>
    <message>
        <source>Friction of a film of oil or grease.</source>
        <translation>Reibung eines Films aus Öl oder Fett.</translation>
    </message>
    <message>
        <source>Friction, drag, loads, springs and inertias attached to a shaft, and what may lie between two shafts.</source>
        <translation>Reibung, Widerstände, Lasten, Federn und Trägheiten an einer Welle und was zwischen zwei Wellen liegen kann.</translation>
    </message>
    <message>
        <source>As BasicThermalFluid, with a conductance that is straight in the temperature of the body: the film at its surface, or a coat that conducts better when it is warm.</source>
        <translation>Wie BasicThermalFluid, mit einem Leitwert, der linear mit der Temperatur des Körpers geht: der Film an seiner Oberfläche oder eine Schicht, die warm besser leitet.</translation>
    </message>
    <message>
        <source>A drag that grows faster than the square of the speed.</source>
        <translation>Ein Widerstand, der schneller als mit dem Quadrat der Drehzahl wächst.</translation>
    </message>
    <message>
        <source>A driver that takes voltage back where the current would pass its limit; the recorded voltage is the command.</source>
        <translation>Ein Treiber, der Spannung zurücknimmt, wo der Strom seine Grenze überschritte; die aufgezeichnete Spannung ist der Befehl.</translation>
    </message>
    <message>
        <source>A heater whose resistance bends over a wide range of temperature, as that of platinum or of a ceramic does.</source>
        <translation>Ein Heizer, dessen Widerstand sich über einen weiten Temperaturbereich krümmt, wie der von Platin oder einer Keramik.</translation>
    </message>
    <message>
        <source>A cam, an eccentric gear or an uneven pull of the poles: the torque depends on the angle, and a single wave does not describe it.</source>
        <translation>Ein Nocken, ein exzentrisches Zahnrad oder ein ungleicher Zug der Pole: Das Drehmoment hängt vom Winkel ab, und eine einzelne Welle beschreibt es nicht.</translation>
    </message>
    <message>
        <source>A rotary magnet or a torque motor that leaves the angle at which it pulls best.</source>
        <translation>Ein Drehmagnet oder Momentenmotor, der den Winkel verlässt, bei dem er am besten zieht.</translation>
    </message>
    <message>
        <source>A condition that changed in mid run: a fan, a draught, a neighbour.</source>
        <translation>Eine Bedingung, die sich mitten im Lauf geändert hat: ein Lüfter, ein Luftzug, ein Nachbar.</translation>
    </message>
    <message>
        <source>A driver that takes voltage back where the current of a cold heater would pass its limit; the recorded voltage is the command.</source>
        <translation>Ein Treiber, der Spannung zurücknimmt, wo der Strom eines kalten Heizers seine Grenze überschritte; die aufgezeichnete Spannung ist der Befehl.</translation>
    </message>
    <message>
        <source>A driver that takes voltage back where the heater would take more than so much power; the recorded voltage is the command.</source>
        <translation>Ein Treiber, der Spannung zurücknimmt, wo der Heizer mehr als eine gewisse Leistung aufnähme; die aufgezeichnete Spannung ist der Befehl.</translation>
    </message>
    <message>
        <source>A torque that does not come at once where the motion turns round, but over a travel, whatever the speed: the bristles of a seal, the hysteresis of a spring, of a magnet or of a belt (Dahl 1968).</source>
        <translation>Ein Drehmoment, das bei der Umkehr der Bewegung nicht sofort kommt, sondern über einen Weg, gleich wie schnell: die Borsten einer Dichtung, die Hysterese einer Feder, eines Magneten oder eines Riemens (Dahl 1968).</translation>
    </message>
    <message>
        <source>A spring, a bush or a seal that grows stiffer the further it is moved from where the recording begins.</source>
        <translation>Eine Feder, eine Buchse oder eine Dichtung, die umso steifer wird, je weiter sie von dort bewegt wird, wo die Aufzeichnung beginnt.</translation>
    </message>
    <message>
        <source>Something that happened once in the run: a splash of water, a door that was open, a neighbour that was on.</source>
        <translation>Etwas, das im Lauf einmal geschah: ein Schwall Wasser, eine offene Tür, ein eingeschalteter Nachbar.</translation>
    </message>
    <message>
        <source>Something that happened once in the run: a hand on the shaft, a body in the way, a gust.</source>
        <translation>Etwas, das im Lauf einmal geschah: eine Hand an der Welle, ein Körper im Weg, eine Bö.</translation>
    </message>
    <message>
        <source>A thermostat that opens, a liquid that begins to boil, a fan that is switched on: from a temperature on the body loses more.</source>
        <translation>Ein Thermostat, der öffnet, eine Flüssigkeit, die zu sieden beginnt, ein Lüfter, der anläuft: Von einer Temperatur an verliert der Körper mehr.</translation>
    </message>
    <message>
        <source>A stop, a seal or an end of travel.</source>
        <translation>Ein Anschlag, eine Dichtung oder ein Ende des Wegs.</translation>
    </message>
    <message>
        <source>Something outside the model that heats or cools at its own pace.</source>
        <translation>Etwas außerhalb des Modells, das in eigenem Takt heizt oder kühlt.</translation>
    </message>
    <message>
        <source>Something outside the model that turns or switches at its own pace.</source>
        <translation>Etwas außerhalb des Modells, das in eigenem Takt dreht oder schaltet.</translation>
    </message>
    <message>
        <source>Heat flow that was recorded but not given to the model: a multiple of a recorded channel of its unit.</source>
        <translation>Wärmestrom, der aufgezeichnet, aber dem Modell nicht gegeben wurde: ein Vielfaches eines aufgezeichneten Kanals seiner Einheit.</translation>
    </message>
    <message>
        <source>Torque that was recorded but not given to the model: a multiple of a recorded channel of its unit.</source>
        <translation>Drehmoment, das aufgezeichnet, aber dem Modell nicht gegeben wurde: ein Vielfaches eines aufgezeichneten Kanals seiner Einheit.</translation>
    </message>
    <message>
        <source>A machine whose iron saturates, or whose field the current of the armature weakens.</source>
        <translation>Eine Maschine, deren Eisen sättigt oder deren Feld der Ankerstrom schwächt.</translation>
    </message>
    <message>
        <source>A sensor or an amplifier that runs into its limit.</source>
        <translation>Ein Sensor oder Verstärker, der an seine Grenze stößt.</translation>
    </message>
    <message>
        <source>A sensor that was knocked, unplugged or re-zeroed in mid run.</source>
        <translation>Ein Sensor, der mitten im Lauf angestoßen, ausgesteckt oder neu genullt wurde.</translation>
    </message>
    <message>
        <source>Base of what conducts heat and stores none. A class that extends it adds one equation for Q_flow.</source>
        <translation>Basis für alles, was Wärme leitet und keine speichert. Eine erweiternde Klasse ergänzt eine Gleichung für Q_flow.</translation>
    </message>
    <message>
        <source>A bond, a paste or a gap that conducts better or worse when it is warm.</source>
        <translation>Eine Klebung, eine Paste oder ein Spalt, die warm besser oder schlechter leiten.</translation>
    </message>
    <message>
        <source>A layer of air or liquid that moves by itself, the more the warmer one side is: natural convection where the model has a mere conductance.</source>
        <translation>Eine Schicht aus Luft oder Flüssigkeit, die sich von selbst bewegt, umso mehr, je wärmer eine Seite ist: freie Konvektion, wo das Modell nur einen Leitwert hat.</translation>
    </message>
    <message>
        <source>As ConvectionByFlowSpeed, with the conductance multiplied by a power of the difference between body and stream.</source>
        <translation>Wie ConvectionByFlowSpeed, der Leitwert jedoch mit einer Potenz der Differenz zwischen Körper und Strom multipliziert.</translation>
    </message>
    <message>
        <source>As ConvectionByFlowSpeed, with the conductance multiplied by a power of a second measured flow: a radiator in the wind of the car, through which a pump drives the coolant. At n = 0 that flow plays no part. Below a thousandth of flow_ref it counts as that.</source>
        <translation>Wie ConvectionByFlowSpeed, der Leitwert jedoch mit einer Potenz eines zweiten gemessenen Durchflusses multipliziert: ein Kühler im Fahrtwind, durch den eine Pumpe das Kühlmittel treibt. Bei n = 0 spielt dieser Durchfluss keine Rolle. Unter einem Tausendstel von flow_ref zählt er wie dieses.</translation>
    </message>
    <message>
        <source>The mains, a fan or a beat with the sampling that reaches the cable or the amplifier and not the component.</source>
        <translation>Das Netz, ein Lüfter oder eine Schwebung mit der Abtastung, die das Kabel oder den Verstärker erreicht und nicht die Komponente.</translation>
    </message>
    <message>
        <source>A condition that changed in mid run: a load that came or went.</source>
        <translation>Eine Bedingung, die sich mitten im Lauf geändert hat: eine Last, die kam oder ging.</translation>
    </message>
    <message>
        <source>A guide or a gear that runs harder one way than the other.</source>
        <translation>Eine Führung oder ein Getriebe, das in einer Richtung schwerer läuft als in der anderen.</translation>
    </message>
    <message>
        <source>Forms that compete with the named effects. Where one of them explains the measurement clearly better, none of the names fits: the search then says so, names the place and proposes the equation. It is never added by itself.</source>
        <translation>Formen, die mit den benannten Effekten im Wettbewerb stehen. Wo eine von ihnen die Messung deutlich besser erklärt, passt keiner der Namen: Die Suche sagt das, nennt den Ort und schlägt die Gleichung vor. Von selbst wird sie nie hinzugefügt.</translation>
    </message>
    <message>
        <source>An error of a sensor: inserted in front of a measured output.</source>
        <translation>Ein Fehler eines Sensors: vor einem gemessenen Ausgang eingefügt.</translation>
    </message>
    <message>
        <source>Errors of sensors, inserted in front of an output.</source>
        <translation>Fehler von Sensoren, vor einem Ausgang eingefügt.</translation>
    </message>
    <message>
        <source>Shared by the effects of sensors and actuators.</source>
        <translation>Den Effekten von Sensoren und Stellgliedern gemeinsam.</translation>
    </message>
    <message>
        <source>Partial classes that the effects of sensors and actuators share.</source>
        <translation>Partielle Klassen, die den Effekten von Sensoren und Stellgliedern gemeinsam sind.</translation>
    </message>
    <message>
        <source>Moisture that evaporates, or a part that melts, on the first heating: between T_l - width/2 and T_l + width/2 the body has the extra heat capacity Q_l/width, until the heat Q_l is taken up. It does not come back on cooling.</source>
        <translation>Feuchte, die verdampft, oder ein Teil, das schmilzt, beim ersten Aufheizen: Zwischen T_l - width/2 und T_l + width/2 hat der Körper die zusätzliche Wärmekapazität Q_l/width, bis die Wärme Q_l aufgenommen ist. Beim Abkühlen kommt sie nicht zurück.</translation>
    </message>
    <message>
        <source>Conduction or convection to surroundings at the constant temperature T_amb.</source>
        <translation>Leitung oder Konvektion an eine Umgebung der konstanten Temperatur T_amb.</translation>
    </message>
    <message>
        <source>Conduction or convection to surroundings whose temperature is a recorded channel that the model does not use.</source>
        <translation>Leitung oder Konvektion an eine Umgebung, deren Temperatur ein aufgezeichneter Kanal ist, den das Modell nicht verwendet.</translation>
    </message>
    <message>
        <source>Conduction or convection to surroundings at a constant temperature that is fitted, too: a climate chamber, a cold start, the air around a hot engine.</source>
        <translation>Leitung oder Konvektion an eine Umgebung konstanter Temperatur, die mit angepasst wird: eine Klimakammer, ein Kaltstart, die Luft um einen heißen Motor.</translation>
    </message>
    <message>
        <source>A part that is heated through a conductance G2 and stores heat: a holder, a housing, a layer. It starts at the temperature of the port. The conductance is given by the time constant, G2 = C2/tau_2.</source>
        <translation>Ein Teil, das über einen Leitwert G2 erwärmt wird und Wärme speichert: ein Halter, ein Gehäuse, eine Schicht. Es beginnt mit der Temperatur des Anschlusses. Der Leitwert folgt aus der Zeitkonstante, G2 = C2/tau_2.</translation>
    </message>
    <message>
        <source>Heat radiated to surroundings at the constant temperature T_amb.</source>
        <translation>Wärme, die an eine Umgebung der konstanten Temperatur T_amb abgestrahlt wird.</translation>
    </message>
    <message>
        <source>Heat radiated to a wall whose temperature is a recorded channel that the model does not use.</source>
        <translation>Wärme, die an eine Wand abgestrahlt wird, deren Temperatur ein aufgezeichneter Kanal ist, den das Modell nicht verwendet.</translation>
    </message>
    <message>
        <source>Heat radiated to surroundings at a constant temperature that is fitted, too.</source>
        <translation>Wärme, die an eine Umgebung konstanter Temperatur abgestrahlt wird, die mit angepasst wird.</translation>
    </message>
    <message>
        <source>A joint, a gap or a layer that heat must pass and that stores none.</source>
        <translation>Eine Fuge, ein Spalt oder eine Schicht, die Wärme durchqueren muss und die keine speichert.</translation>
    </message>
    <message>
        <source>Losses, radiation and masses attached to a heat port, and resistances between two.</source>
        <translation>Verluste, Strahlung und Massen an einem Wärmeanschluss und Widerstände zwischen zweien.</translation>
    </message>
    <message>
        <source>As BasicThermalFluid, with the conductance multiplied by a power of a measured flow: the speed of the gas, the throughput of a pump. At n = 0 the flow plays no part. Below a thousandth of flow_ref the flow counts as that.</source>
        <translation>Wie BasicThermalFluid, der Leitwert multipliziert mit einer Potenz eines gemessenen Durchflusses: der Geschwindigkeit des Gases, der Förderung einer Pumpe. Bei n = 0 spielt der Durchfluss keine Rolle. Unter einem Tausendstel von flow_ref zählt er wie dieses.</translation>
    </message>
    <message>
        <source>As BasicThermalFluid, with the conductance multiplied by a power of the difference between body and stream, as natural convection has it (n about 0.25 to 0.33).</source>
        <translation>Wie BasicThermalFluid, der Leitwert multipliziert mit einer Potenz der Differenz zwischen Körper und Strömung, wie bei natürlicher Konvektion (n etwa 0,25 bis 0,33).</translation>
    </message>
    <message>
        <source>The difference is smoothed below dT_eps so that the power has a slope at 0.</source>
        <translation>Die Differenz wird unter dT_eps geglättet, damit die Potenz bei 0 eine Steigung hat.</translation>
    </message>
    <message>
        <source>Classes that replace BasicThermalFluid: they extend the same base and take the same parameters.</source>
        <translation>Klassen, die BasicThermalFluid ersetzen: Sie erweitern dieselbe Basis und haben dieselben Parameter.</translation>
    </message>
    <message>
        <source>An effect is an ordinary class with a vendor annotation that says its kind, where it may go and which parameter is its strength. At strength 0 the model is the one without the effect.</source>
        <translation>Ein Effekt ist eine gewöhnliche Klasse mit einer eigenen Annotation, die seine Art nennt, wo er stehen darf und welcher Parameter seine Stärke ist. Bei Stärke 0 ist das Modell das ohne den Effekt.</translation>
    </message>
    <message>
        <source>Three ways to add one: attach it to a connection (one connector), insert it into a connection or a signal (two connectors), or specialise a component: its class is replaced by one that extends the same base.</source>
        <translation>Drei Arten, einen hinzuzufügen: ihn an eine Verbindung anhängen (ein Anschluss), ihn in eine Verbindung oder ein Signal einfügen (zwei Anschlüsse) oder ein Bauteil spezialisieren: Seine Klasse wird durch eine ersetzt, die dieselbe Basis erweitert.</translation>
    </message>
    <message>
        <source>A class of your own with the same annotation takes part in the search like these.</source>
        <translation>Eine eigene Klasse mit derselben Annotation nimmt an der Suche teil wie diese.</translation>
    </message>
    <message>
        <source>The basic class of the electrical and mechanical domain: winding with resistance R and inductance L, voltage induced by the turning rotor, torque from the current. The rotor's inertia is not in it; put an inertia on the shaft. The current starts at 0.</source>
        <translation>Die Grundklasse der elektrischen und mechanischen Domäne: Wicklung mit Widerstand R und Induktivität L, vom drehenden Läufer induzierte Spannung, Drehmoment aus dem Strom. Die Trägheit des Läufers ist nicht darin; eine Trägheit an die Welle setzen. Der Strom beginnt bei 0.</translation>
    </message>
    <message>
        <source>L = 0 is legal: the current then follows the voltage at once.</source>
        <translation>L = 0 ist erlaubt: Der Strom folgt der Spannung dann sofort.</translation>
    </message>
    <message>
        <source>Base of the electric machines. A class that extends it adds one equation for the voltage and one for the torque.</source>
        <translation>Basis der elektrischen Maschinen. Eine Klasse, die sie erweitert, fügt eine Gleichung für die Spannung und eine für das Drehmoment hinzu.</translation>
    </message>
    <message>
        <source>BasicElectricMechanical is the basic class: a direct-current machine with permanent field. Extensions inherit from PartialElectricMechanical and so keep connectors and parameters.</source>
        <translation>BasicElectricMechanical ist die Grundklasse: eine permanenterregte Gleichstrommaschine. Erweiterungen erben von PartialElectricMechanical und behalten so Anschlüsse und Parameter.</translation>
    </message>
    <message>
        <source>The basic class of the electrical and thermal domain: a resistor with a linear temperature coefficient gives all its loss to the heat port.</source>
        <translation>Die Grundklasse der elektrischen und thermischen Domäne: Ein Widerstand mit linearem Temperaturkoeffizienten gibt seinen ganzen Verlust an den Wärmeanschluss.</translation>
    </message>
    <message>
        <source>Base of the heaters. A class that extends it adds one equation for the current and one for the heat.</source>
        <translation>Basis der Heizer. Eine Klasse, die sie erweitert, fügt eine Gleichung für den Strom und eine für die Wärme hinzu.</translation>
    </message>
    <message>
        <source>BasicElectricThermal is the basic class: a resistor that heats. Extensions inherit from PartialElectricThermal.</source>
        <translation>BasicElectricThermal ist die Grundklasse: ein Widerstand, der heizt. Erweiterungen erben von PartialElectricThermal.</translation>
    </message>
    <message>
        <source>One end of a shaft: the angle phi is the same for all that is connected, the torques tau into the components sum to zero.</source>
        <translation>Ein Ende einer Welle: Der Winkel phi ist für alles Verbundene derselbe, die Drehmomente tau in die Bauteile summieren sich zu null.</translation>
    </message>
    <message>
        <source>A place that exchanges heat: the temperature T is the same for all that is connected, the heat flows Q_flow into the components sum to zero.</source>
        <translation>Ein Ort, der Wärme austauscht: Die Temperatur T ist für alles Verbundene dieselbe, die Wärmeströme Q_flow in die Bauteile summieren sich zu null.</translation>
    </message>
    <message>
        <source>Base of loads and of effects that act on a shaft. A class that extends it adds one equation for flange.tau.</source>
        <translation>Basis der Lasten und der Effekte, die auf eine Welle wirken. Eine Klasse, die sie erweitert, fügt eine Gleichung für flange.tau hinzu.</translation>
    </message>
    <message>
        <source>Base of effects that take heat from one place. A class that extends it adds one equation for port.Q_flow.</source>
        <translation>Basis der Effekte, die einem Ort Wärme entziehen. Eine Klasse, die sie erweitert, fügt eine Gleichung für port.Q_flow hinzu.</translation>
    </message>
    <message>
        <source>Base of blocks with one input and one output. A class that extends it adds one equation for y.</source>
        <translation>Basis der Blöcke mit einem Eingang und einem Ausgang. Eine Klasse, die sie erweitert, fügt eine Gleichung für y hinzu.</translation>
    </message>
    <message>
        <source>Base of components between two flanges. A class that extends it adds two equations for angles and torques.</source>
        <translation>Basis der Bauteile zwischen zwei Flanschen. Eine Klasse, die sie erweitert, fügt zwei Gleichungen für Winkel und Drehmomente hinzu.</translation>
    </message>
    <message>
        <source>A real signal, read by the block. Give its unit where it is used: RealInput u(unit=&amp;quot;V&amp;quot;).</source>
        <translation>Ein reelles Signal, das der Block liest. Seine Einheit angeben, wo es verwendet wird: RealInput u(unit=&amp;quot;V&amp;quot;).</translation>
    </message>
    <message>
        <source>A real signal, computed by the block.</source>
        <translation>Ein reelles Signal, das der Block berechnet.</translation>
    </message>
    <message>
        <source>Connectors join blocks: at a connection the potentials are equal and the flows sum to zero.</source>
        <translation>Anschlüsse verbinden Blöcke: An einer Verbindung sind die Potentiale gleich, und die Flüsse summieren sich zu null.</translation>
    </message>
    <message>
        <source>The basic class of the mechanical and thermal domain: one rigid shaft runs through; its friction is proportional to the speed, and the loss goes to the heat port.</source>
        <translation>Die Grundklasse der mechanischen und thermischen Domäne: Eine starre Welle läuft durch; ihre Reibung ist proportional zur Drehzahl, und der Verlust geht an den Wärmeanschluss.</translation>
    </message>
    <message>
        <source>Base of bearings and brakes. A class that extends it adds one equation for the friction torque tau_f.</source>
        <translation>Basis der Lager und Bremsen. Eine Klasse, die sie erweitert, fügt eine Gleichung für das Reibmoment tau_f hinzu.</translation>
    </message>
    <message>
        <source>BasicMechanicThermal is the basic class: friction on a shaft whose loss heats a place. Extensions inherit from PartialMechanicThermal.</source>
        <translation>BasicMechanicThermal ist die Grundklasse: Reibung an einer Welle, deren Verlust einen Ort erwärmt. Erweiterungen erben von PartialMechanicThermal.</translation>
    </message>
    <message>
        <source>The basic class of rotational mechanics: an inertia J1 at flange_a, a gear of ratio r, an elastic shaft with stiffness c and damping d, an inertia J2 at flange_b. All starts at rest at angle 0.</source>
        <translation>Die Grundklasse der Drehmechanik: eine Trägheit J1 an flange_a, ein Getriebe der Übersetzung r, eine elastische Welle der Steifigkeit c und Dämpfung d, eine Trägheit J2 an flange_b. Alles beginnt in Ruhe beim Winkel 0.</translation>
    </message>
    <message>
        <source>Stiffness and damping refer to the slow side (flange_b). J1 = 0 or J2 = 0 is legal: the inertia then belongs to what is connected there.</source>
        <translation>Steifigkeit und Dämpfung beziehen sich auf die langsame Seite (flange_b). J1 = 0 oder J2 = 0 ist erlaubt: Die Trägheit gehört dann zu dem, was dort verbunden ist.</translation>
    </message>
    <message>
        <source>The housing: the flange does not turn.</source>
        <translation>Das Gehäuse: Der Flansch dreht sich nicht.</translation>
    </message>
    <message>
        <source>An inertia on a rigid shaft; both flanges are the same place.</source>
        <translation>Eine Trägheit an einer starren Welle; beide Flansche sind derselbe Ort.</translation>
    </message>
    <message>
        <source>Base of the geared shafts. A class that extends it says how the torque tau_s comes about.</source>
        <translation>Basis der Getriebewellen. Eine Klasse, die sie erweitert, sagt, wie das Drehmoment tau_s zustande kommt.</translation>
    </message>
    <message>
        <source>The torque of an impeller or fan at a constant circuit. It always opposes the motion.</source>
        <translation>Das Drehmoment eines Laufrads oder Lüfters an einem festen Kreislauf. Es wirkt immer gegen die Bewegung.</translation>
    </message>
    <message>
        <source>The return spring of a flap or throttle plate.</source>
        <translation>Die Rückstellfeder einer Klappe oder Drosselklappe.</translation>
    </message>
    <message>
        <source>A massless elastic and damped shaft.</source>
        <translation>Eine masselose elastische und gedämpfte Welle.</translation>
    </message>
    <message>
        <source>A damper between shaft and housing.</source>
        <translation>Ein Dämpfer zwischen Welle und Gehäuse.</translation>
    </message>
    <message>
        <source>Components on a shaft. BasicMechanics is the basic class of the domain: two inertias, a gear and an elastic shaft in one block.</source>
        <translation>Bauteile an einer Welle. BasicMechanics ist die Grundklasse der Domäne: zwei Trägheiten, ein Getriebe und eine elastische Welle in einem Block.</translation>
    </message>
    <message>
        <source>Reads the angle of a flange and takes no torque.</source>
        <translation>Liest den Winkel eines Flansches und nimmt kein Drehmoment auf.</translation>
    </message>
    <message>
        <source>Tells the heat that passes and hinders nothing.</source>
        <translation>Sagt, welche Wärme hindurchgeht, und hindert nichts.</translation>
    </message>
    <message>
        <source>Reads the speed of a flange and takes no torque.</source>
        <translation>Liest die Drehzahl eines Flansches und nimmt kein Drehmoment auf.</translation>
    </message>
    <message>
        <source>Reads the temperature of a place and takes no heat.</source>
        <translation>Liest die Temperatur eines Orts und nimmt keine Wärme auf.</translation>
    </message>
    <message>
        <source>A rigid shaft that tells the torque it carries.</source>
        <translation>Eine starre Welle, die sagt, welches Drehmoment sie überträgt.</translation>
    </message>
    <message>
        <source>A sensor reads a variable and changes nothing.</source>
        <translation>Ein Sensor liest eine Größe und ändert nichts.</translation>
    </message>
    <message>
        <source>The output follows the input with the time constant T; it starts at 0.</source>
        <translation>Der Ausgang folgt dem Eingang mit der Zeitkonstante T; er beginnt bei 0.</translation>
    </message>
    <message>
        <source>Multiplies by a constant.</source>
        <translation>Multipliziert mit einer Konstante.</translation>
    </message>
    <message>
        <source>Product of two signals.</source>
        <translation>Produkt zweier Signale.</translation>
    </message>
    <message>
        <source>Sum of two signals.</source>
        <translation>Summe zweier Signale.</translation>
    </message>
    <message>
        <source>Plain arithmetic on signals, and a first-order lag.</source>
        <translation>Einfaches Rechnen mit Signalen und ein Verzögerungsglied erster Ordnung.</translation>
    </message>
    <message>
        <source>Gives out the same value at all times.</source>
        <translation>Gibt zu allen Zeiten denselben Wert aus.</translation>
    </message>
    <message>
        <source>The surroundings at a constant temperature.</source>
        <translation>Die Umgebung mit konstanter Temperatur.</translation>
    </message>
    <message>
        <source>Gives the heat Q_flow to whatever is connected, at any temperature.</source>
        <translation>Gibt die Wärme Q_flow an alles Verbundene, bei jeder Temperatur.</translation>
    </message>
    <message>
        <source>A stream or body so large that its temperature is not changed by the heat it takes.</source>
        <translation>Eine Strömung oder ein Körper, so groß, dass die aufgenommene Wärme seine Temperatur nicht ändert.</translation>
    </message>
    <message>
        <source>Drives the shaft with the torque tau, at any speed; the housing takes the reaction.</source>
        <translation>Treibt die Welle mit dem Drehmoment tau, bei jeder Drehzahl; das Gehäuse nimmt das Gegenmoment auf.</translation>
    </message>
    <message>
        <source>What the surroundings impose. Prescribed sources read a signal, fixed ones have a parameter.</source>
        <translation>Was die Umgebung vorgibt. Vorgegebene Quellen lesen ein Signal, feste haben einen Parameter.</translation>
    </message>
    <message>
        <source>The program knows this function itself, with its derivative; the algorithm is for other tools.</source>
        <translation>Das Programm kennt diese Funktion selbst, mit ihrer Ableitung; der Algorithmus ist für andere Werkzeuge.</translation>
    </message>
    <message>
        <source>Fritsch and Carlson, SIAM J. Numer. Anal. 17 (1980) 238-246: a cubic on each piece, with slopes that keep it monotone. The program knows this function itself, with its derivative; the algorithm is for other tools.</source>
        <translation>Fritsch und Carlson, SIAM J. Numer. Anal. 17 (1980) 238-246: ein kubisches Polynom auf jedem Stück, mit Steigungen, die es monoton halten. Das Programm kennt diese Funktion selbst, mit ihrer Ableitung; der Algorithmus ist für andere Werkzeuge.</translation>
    </message>
    <message>
        <source>Values between measured points, for equations of a block: &lt;code&gt;y = Analogon.Tables.linear(u, {0, 1, 2}, {0, 1, 4})&lt;/code&gt;. The points must be known before the simulation and their abscissas must rise. Outside the points the value goes on with the outer slope.</source>
        <translation>Werte zwischen gemessenen Punkten, für Gleichungen eines Blocks: &lt;code&gt;y = Analogon.Tables.linear(u, {0, 1, 2}, {0, 1, 4})&lt;/code&gt;. Die Punkte müssen vor der Simulation bekannt sein, ihre Abszissen müssen steigen. Außerhalb der Punkte geht der Wert mit der äußeren Steigung weiter.</translation>
    </message>
    <message>
        <source>A body that stores heat and has one temperature throughout.</source>
        <translation>Ein Körper, der Wärme speichert und durchweg eine Temperatur hat.</translation>
    </message>
    <message>
        <source>A wall, a bond or a wire that conducts heat and stores none.</source>
        <translation>Eine Wand, eine Verbindung oder ein Draht, der Wärme leitet und keine speichert.</translation>
    </message>
    <message>
        <source>Lumped heat capacities and conductances.</source>
        <translation>Konzentrierte Wärmekapazitäten und Leitwerte.</translation>
    </message>
    <message>
        <source>The basic class of the thermal and fluid domain: a body of uniform temperature exchanges heat with a stream. The conductance grows with the temperature of the fluid: in kelvin, it stands under the exponent.</source>
        <translation>Die Grundklasse der thermischen und fluidischen Domäne: Ein Körper einheitlicher Temperatur tauscht Wärme mit einer Strömung. Der Leitwert wächst mit der Temperatur des Fluids: In Kelvin steht sie unter dem Exponenten.</translation>
    </message>
    <message>
        <source>It descends from the law of Juerges, which has the speed of the stream in km/h in that place; see ConvectionByFlowSpeed. Only the product c_o*A shows in a measurement: keep one of the two.</source>
        <translation>Er stammt vom Gesetz von Jürges ab, das an dieser Stelle die Geschwindigkeit der Strömung in km/h hat; siehe ConvectionByFlowSpeed. Nur das Produkt c_o*A zeigt sich in einer Messung: eines von beiden festhalten.</translation>
    </message>
    <message>
        <source>As BasicThermalFluid, with the speed of the stream under the exponent: the law of Juerges. The speed is in km/h, so speed/3.6 is in m/s. A stream that stands still takes no heat; a negative speed counts as 0.</source>
        <translation>Wie BasicThermalFluid, mit der Geschwindigkeit der Strömung unter dem Exponenten: das Gesetz von Jürges. Die Geschwindigkeit ist in km/h, speed/3.6 also in m/s. Eine ruhende Strömung nimmt keine Wärme auf; eine negative Geschwindigkeit zählt als 0.</translation>
    </message>
    <message>
        <source>Base of the bodies in a stream. A class that extends it adds one equation for the conductance G_c.</source>
        <translation>Basis der Körper in einer Strömung. Eine Klasse, die sie erweitert, fügt eine Gleichung für den Leitwert G_c hinzu.</translation>
    </message>
    <message>
        <source>BasicThermalFluid is the basic class: a body with heat capacity that exchanges heat with a stream. Extensions inherit from PartialThermalFluid.</source>
        <translation>BasicThermalFluid ist die Grundklasse: ein Körper mit Wärmekapazität, der Wärme mit einer Strömung tauscht. Erweiterungen erben von PartialThermalFluid.</translation>
    </message>
    <message>
        <source>Blocks of the mechanical, electrical, thermal and fluid domains from which a component is composed, one class per pair of coupled domains, with sources, sensors and loads, and the effects that a measurement may show to be missing.</source>
        <translation>Blöcke der mechanischen, elektrischen, thermischen und fluidischen Domäne, aus denen ein Bauteil zusammengesetzt wird, eine Klasse je Paar gekoppelter Domänen, mit Quellen, Sensoren und Lasten und den Effekten, die nach einer Messung fehlen können.</translation>
    </message>
    <message>
        <source>Variables and signs are those of the Modelica Standard Library: a rotational flange carries the angle phi and the flow tau, a heat port the temperature T and the flow Q_flow; a flow is positive into the component. The library needs no other library.</source>
        <translation>Größen und Vorzeichen sind die der Modelica Standard Library: Ein Drehflansch hat den Winkel phi und den Fluss tau, ein Wärmeanschluss die Temperatur T und den Fluss Q_flow; ein Fluss ist in das Bauteil hinein positiv. Die Bibliothek braucht keine andere.</translation>
    </message>
    <message>
        <source>A new block is one more text file: extend the partial class of its domain package and add the equations.</source>
        <translation>Ein neuer Block ist eine weitere Textdatei: die partielle Klasse seines Domänenpakets erweitern und die Gleichungen hinzufügen.</translation>
    </message>
    <message>
        <source>Heat flow into the component</source>
        <translation>Wärmestrom in das Bauteil hinein</translation>
    </message>
    <message>
        <source>Torque into the component</source>
        <translation>Drehmoment in das Bauteil hinein</translation>
    </message>
    <message>
        <source>Piece that holds x</source>
        <translation>Stück, in dem x liegt</translation>
    </message>
    <message>
        <source>The film in a plug or under a spring contact: it conducts the better the more current flows. With m = 1 its voltage rises to R_c*i_c and stays there, with m = 2 it falls again.</source>
        <translation>Der Film in einem Stecker oder unter einem Federkontakt: Er leitet umso besser, je mehr Strom fließt. Mit m = 1 steigt seine Spannung auf R_c*i_c und bleibt dort, mit m = 2 fällt sie wieder.</translation>
    </message>
    <message>
        <source>The film under a brush or in a plug: it conducts the better the more current flows. With m = 1 its voltage rises to R_c*i_c and stays there, with m = 2 it falls again.</source>
        <translation>Der Film unter einer Bürste oder in einem Stecker: Er leitet umso besser, je mehr Strom fließt. Mit m = 1 steigt seine Spannung auf R_c*i_c und bleibt dort, mit m = 2 fällt sie wieder.</translation>
    </message>
    <message>
        <source>A step</source>
        <translation>Ein Sprung</translation>
    </message>
    <message>
        <source>A ramp</source>
        <translation>Eine Rampe</translation>
    </message>
    <message>
        <source>A sine</source>
        <translation>Ein Sinus</translation>
    </message>
    <message>
        <source>A train of pulses</source>
        <translation>Eine Folge von Impulsen</translation>
    </message>
    <message>
        <source>A train of trapezoids</source>
        <translation>Eine Folge von Trapezen</translation>
    </message>
    <message>
        <source>A sine whose frequency rises</source>
        <translation>Ein Sinus, dessen Frequenz steigt</translation>
    </message>
    <message>
        <source>A signal through points</source>
        <translation>Ein Signal durch Punkte</translation>
    </message>
    <message>
        <source>Height of the step, in the unit of what is connected</source>
        <translation>Höhe des Sprungs, in der Einheit dessen, was verbunden ist</translation>
    </message>
    <message>
        <source>Height that is reached, in the unit of what is connected</source>
        <translation>Höhe, die erreicht wird, in der Einheit dessen, was verbunden ist</translation>
    </message>
    <message>
        <source>Amplitude, in the unit of what is connected</source>
        <translation>Amplitude, in der Einheit dessen, was verbunden ist</translation>
    </message>
    <message>
        <source>Value before the start, in the unit of what is connected</source>
        <translation>Wert vor dem Beginn, in der Einheit dessen, was verbunden ist</translation>
    </message>
    <message>
        <source>Value about which it swings, in the unit of what is connected</source>
        <translation>Wert, um den es schwingt, in der Einheit dessen, was verbunden ist</translation>
    </message>
    <message>
        <source>Height of the pulses, in the unit of what is connected</source>
        <translation>Höhe der Impulse, in der Einheit dessen, was verbunden ist</translation>
    </message>
    <message>
        <source>Height of the trapezoids, in the unit of what is connected</source>
        <translation>Höhe der Trapeze, in der Einheit dessen, was verbunden ist</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Beginn</translation>
    </message>
    <message>
        <source>Duration of the rise</source>
        <translation>Dauer des Anstiegs</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>Phase at the start</source>
        <translation>Phase zu Beginn</translation>
    </message>
    <message>
        <source>Part of the period that a pulse lasts</source>
        <translation>Teil der Periode, den ein Impuls dauert</translation>
    </message>
    <message>
        <source>Duration of the flat top</source>
        <translation>Dauer des Dachs</translation>
    </message>
    <message>
        <source>Duration of the fall</source>
        <translation>Dauer des Abfalls</translation>
    </message>
    <message>
        <source>Time since the present period began</source>
        <translation>Zeit seit Beginn der laufenden Periode</translation>
    </message>
    <message>
        <source>Frequency at the start</source>
        <translation>Frequenz zu Beginn</translation>
    </message>
    <message>
        <source>Frequency at the end</source>
        <translation>Frequenz am Ende</translation>
    </message>
    <message>
        <source>Duration of the sweep</source>
        <translation>Dauer des Durchlaufs</translation>
    </message>
    <message>
        <source>Time since the start</source>
        <translation>Zeit seit dem Beginn</translation>
    </message>
    <message>
        <source>Time that the frequency has risen</source>
        <translation>Zeit, die die Frequenz gestiegen ist</translation>
    </message>
    <message>
        <source>Times of the points, rising</source>
        <translation>Zeiten der Punkte, steigend</translation>
    </message>
    <message>
        <source>Values at these times, in the unit of what is connected</source>
        <translation>Werte zu diesen Zeiten, in der Einheit dessen, was verbunden ist</translation>
    </message>
    <message>
        <source>Keeps one value until the start, and another one from then on.</source>
        <translation>Behält bis zum Beginn einen Wert, und von da an einen anderen.</translation>
    </message>
    <message>
        <source>Rises on a straight line from one value to another, and keeps it. A duration of 0 makes it a step.</source>
        <translation>Steigt auf einer Geraden von einem Wert zu einem anderen und behält ihn. Mit einer Dauer von 0 ist es ein Sprung.</translation>
    </message>
    <message>
        <source>Swings about the offset from the start on.</source>
        <translation>Schwingt vom Beginn an um den Versatz.</translation>
    </message>
    <message>
        <source>Switches a value on and off again, once in each period from the start on.</source>
        <translation>Schaltet vom Beginn an einmal in jeder Periode einen Wert ein und wieder aus.</translation>
    </message>
    <message>
        <source>Rises to a value, keeps it, falls back and waits for the next period.</source>
        <translation>Steigt auf einen Wert, behält ihn, fällt zurück und wartet auf die nächste Periode.</translation>
    </message>
    <message>
        <source>A sine that excites one frequency after the other: its frequency runs on a straight line from f1 to f2, and stays there.</source>
        <translation>Ein Sinus, der eine Frequenz nach der anderen anregt: Seine Frequenz läuft auf einer Geraden von f1 nach f2 und bleibt dort.</translation>
    </message>
    <message>
        <source>Runs on straight lines from point to point; before the first and behind the last it keeps their values.</source>
        <translation>Läuft auf Geraden von Punkt zu Punkt; vor dem ersten und hinter dem letzten behält es deren Werte.</translation>
    </message>
</context>
<context>
    <name>Language</name>
    <message>
        <source>en</source>
        <translation>de</translation>
    </message>
</context>
<context>
    <name>LibraryPanel</name>
    <message>
        <source>Search blocks</source>
        <translation>Blöcke suchen</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothek</translation>
    </message>
    <message>
        <source>Documentation</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>Drag a block onto the diagram, or choose one and press Enter.</source>
        <translation>Einen Block auf das Diagramm ziehen oder auswählen und die Eingabetaste drücken.</translation>
    </message>
    <message>
        <source>No block is called “%1” or described so. A shorter word may find more.</source>
        <translation>Kein Block heißt „%1“ oder ist so beschrieben. Ein kürzeres Wort findet vielleicht mehr.</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>Campaign …</source>
        <translation>Kampagne …</translation>
    </message>
    <message>
        <source>One study for a whole series of units: started, watched, and each unit's study opened</source>
        <translation>Eine Studie für eine ganze Serie von Exemplaren: starten, verfolgen und die Studie jedes Exemplars öffnen</translation>
    </message>
    <message>
        <source>Recovered work</source>
        <translation>Wiederhergestellte Arbeit</translation>
    </message>
    <message>
        <source>The text has a fault: this is the model as it was before. A click shows the fault.</source>
        <translation>Der Text hat einen Fehler: dies ist das Modell, wie es davor war. Ein Klick zeigt den Fehler.</translation>
    </message>
    <message>
        <source>Open a study first.</source>
        <translation>Zuerst eine Studie öffnen.</translation>
    </message>
    <message>
        <source>The model has an error: %1</source>
        <translation>Das Modell hat einen Fehler: %1</translation>
    </message>
    <message>
        <source>Import a measurement first, and map a column of it to an output.</source>
        <translation>Zuerst eine Messung importieren und eine ihrer Spalten einem Ausgang zuordnen.</translation>
    </message>
    <message>
        <source>Error in the model: no run</source>
        <translation>Fehler im Modell: kein Lauf</translation>
    </message>
    <message>
        <source>%1 is a file of its own: open it in an editor.</source>
        <translation>%1 ist eine eigene Datei: in einem Editor öffnen.</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Läufe</translation>
    </message>
    <message>
        <source>Measured and simulated</source>
        <translation>Gemessen und simuliert</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Start an empty study</source>
        <translation>Eine leere Studie beginnen</translation>
    </message>
    <message>
        <source>Generate from measurement …</source>
        <translation>Aus Messung erzeugen …</translation>
    </message>
    <message>
        <source>Compose a first model from the domains of a component and a recording</source>
        <translation>Aus den Domänen eines Bauteils und einer Aufzeichnung ein erstes Modell zusammensetzen</translation>
    </message>
    <message>
        <source>Open …</source>
        <translation>Öffnen …</translation>
    </message>
    <message>
        <source>Open a study file</source>
        <translation>Eine Studiendatei öffnen</translation>
    </message>
    <message>
        <source>Open directory …</source>
        <translation>Verzeichnis öffnen …</translation>
    </message>
    <message>
        <source>Open a study that is a directory with study.json</source>
        <translation>Eine Studie öffnen, die ein Verzeichnis mit study.json ist</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save the study</source>
        <translation>Die Studie speichern</translation>
    </message>
    <message>
        <source>Save as …</source>
        <translation>Speichern unter …</translation>
    </message>
    <message>
        <source>Save the study as another file</source>
        <translation>Die Studie als andere Datei speichern</translation>
    </message>
    <message>
        <source>Import measurement …</source>
        <translation>Messung importieren …</translation>
    </message>
    <message>
        <source>Write report …</source>
        <translation>Bericht schreiben …</translation>
    </message>
    <message>
        <source>Write report, traces and the completed study into a directory</source>
        <translation>Bericht, Kurven und ergänzte Studie in ein Verzeichnis schreiben</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Estimate the checked parameters</source>
        <translation>Die angehakten Parameter schätzen</translation>
    </message>
    <message>
        <source>Discover</source>
        <translation>Effekt suchen</translation>
    </message>
    <message>
        <source>Fit, find the effect that the model lacks, add it and refit</source>
        <translation>Anpassen, den fehlenden Effekt finden, mit ihm neu anpassen</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alles zeigen</translation>
    </message>
    <message>
        <source>Show the whole diagram (Space)</source>
        <translation>Das ganze Diagramm zeigen (Leertaste)</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Open recent</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Rechnen</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>Reset layout</source>
        <translation>Anordnung zurücksetzen</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farbschema</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>The language changes at the next start.</source>
        <translation>Die Sprache wechselt beim nächsten Start.</translation>
    </message>
    <message>
        <source>Main</source>
        <translation>Werkzeugleiste</translation>
    </message>
    <message>
        <source>Reading the study …</source>
        <translation>Die Studie wird gelesen …</translation>
    </message>
    <message>
        <source>Saved to %1.</source>
        <translation>In %1 gespeichert.</translation>
    </message>
    <message>
        <source>No copy of the unsaved work can be kept: %1</source>
        <translation>Von der ungespeicherten Arbeit lässt sich keine Kopie anlegen: %1</translation>
    </message>
    <message>
        <source>Not saved: %1</source>
        <translation>Nicht gespeichert: %1</translation>
    </message>
    <message>
        <source>see the messages</source>
        <translation>siehe Meldungen</translation>
    </message>
    <message>
        <source>Messages (%1)</source>
        <translation>Meldungen (%1)</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
    <message>
        <source>Go to</source>
        <translation>Gehe zu</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>FMU …</source>
        <translation>FMU …</translation>
    </message>
    <message>
        <source>Modelica …</source>
        <translation>Modelica …</translation>
    </message>
    <message>
        <source>CSV …</source>
        <translation>CSV …</translation>
    </message>
    <message>
        <source>MDF 4 …</source>
        <translation>MDF 4 …</translation>
    </message>
    <message>
        <source>What was measured, what the model says and the difference, as groups of channels (ASAM MDF 4)</source>
        <translation>Was gemessen wurde, was das Modell sagt und der Unterschied, als Gruppen von Kanälen (ASAM MDF 4)</translation>
    </message>
    <message>
        <source>Parameters …</source>
        <translation>Parameter …</translation>
    </message>
    <message>
        <source>The parameters for tools of calibration: CSV, JSON, SSV (SSP), DCM or CDFX</source>
        <translation>Die Parameter für Werkzeuge der Applikation: CSV, JSON, SSV (SSP), DCM oder CDFX</translation>
    </message>
    <message>
        <source>The model with its values for other simulation tools: FMI 2.0, Co-Simulation and Model Exchange</source>
        <translation>Das Modell mit seinen Werten für andere Simulationswerkzeuge: FMI 2.0, Co-Simulation und Model Exchange</translation>
    </message>
    <message>
        <source>The model with its values and the classes it uses, as one Modelica text</source>
        <translation>Das Modell mit seinen Werten und den Klassen, die es verwendet, als ein Modelica-Text</translation>
    </message>
    <message>
        <source>What was measured and what the model says as it stands, of every experiment</source>
        <translation>Was gemessen wurde und was das Modell in seinem jetzigen Stand sagt, für jeden Versuch</translation>
    </message>
    <message>
        <source>Functional Mock-up Units (*.fmu)</source>
        <translation>Functional Mock-up Units (*.fmu)</translation>
    </message>
    <message>
        <source>Modelica texts (*.mo)</source>
        <translation>Modelica-Texte (*.mo)</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>ASAM MDF (*.mf4)</source>
        <translation>ASAM MDF (*.mf4)</translation>
    </message>
    <message>
        <source>Parameters (*.csv *.json *.ssv *.dcm *.cdfx)</source>
        <translation>Parameter (*.csv *.json *.ssv *.dcm *.cdfx)</translation>
    </message>
    <message>
        <source>Exporting …</source>
        <translation>Wird exportiert …</translation>
    </message>
    <message>
        <source>Exporting</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Nothing exported: see the messages.</source>
        <translation>Nichts exportiert: siehe Meldungen.</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Anpassen</translation>
    </message>
    <message>
        <source>Model text beside the diagram</source>
        <translation>Modelltext neben dem Diagramm</translation>
    </message>
    <message>
        <source>Diagram and text side by side: what is changed in one is seen in the other</source>
        <translation>Diagramm und Text nebeneinander: Was in einem geändert wird, erscheint im anderen</translation>
    </message>
    <message>
        <source>Diagram and text</source>
        <translation>Diagramm und Text</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signale</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Arrange for the model</source>
        <translation>Für das Modell anordnen</translation>
    </message>
    <message>
        <source>Arrange for the data</source>
        <translation>Für die Daten anordnen</translation>
    </message>
    <message>
        <source>Arrange for the result</source>
        <translation>Für das Ergebnis anordnen</translation>
    </message>
    <message>
        <source>Table of recordings</source>
        <translation>Tabelle der Aufzeichnungen</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Aufzeichnungen</translation>
    </message>
    <message>
        <source>All recordings as a table: sort them, edit role and weight, fit some of them alone</source>
        <translation>Alle Aufzeichnungen als Tabelle: sortieren, Rolle und Gewicht ändern, einige allein anpassen</translation>
    </message>
    <message>
        <source>The model is not finished: %1</source>
        <translation>Das Modell ist noch nicht fertig: %1</translation>
    </message>
    <message>
        <source>Not connected yet: no run</source>
        <translation>Noch nicht verbunden: kein Lauf</translation>
    </message>
    <message>
        <source>Simulate</source>
        <translation>Simulieren</translation>
    </message>
    <message>
        <source>Simulate the model: over its recordings, and by itself where sources drive it</source>
        <translation>Das Modell simulieren: über seine Aufzeichnungen, und für sich, wo Quellen es antreiben</translation>
    </message>
    <message>
        <source>Record as measurement …</source>
        <translation>Als Messung aufzeichnen …</translation>
    </message>
    <message>
        <source>Make a recording to practise on from the simulation, with noise</source>
        <translation>Aus der Simulation eine Übungsaufzeichnung machen, mit Rauschen</translation>
    </message>
    <message>
        <source>Recorded to %1.</source>
        <translation>Aufgezeichnet in %1.</translation>
    </message>
    <message>
        <source>Open the report</source>
        <translation>Bericht öffnen</translation>
    </message>
    <message>
        <source>Search ten times as long</source>
        <translation>Zehnmal so lange suchen</translation>
    </message>
    <message>
        <source>Discover again, with ten times the work that it had</source>
        <translation>Noch einmal suchen, mit dem Zehnfachen der Arbeit</translation>
    </message>
    <message>
        <source>To be fitted:</source>
        <translation>Anzupassen:</translation>
    </message>
    <message>
        <source>Fitted:</source>
        <translation>Angepasst:</translation>
    </message>
    <message>
        <source>At a bound after the fit:</source>
        <translation>Nach der Anpassung an einer Grenze:</translation>
    </message>
    <message>
        <source>%1 for the recording %2</source>
        <translation>%1 für die Aufzeichnung %2</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>Changed by the effect %1</source>
        <translation>Verändert durch den Effekt %1</translation>
    </message>
    <message>
        <source>Brought by the effect %1</source>
        <translation>Hinzugekommen mit dem Effekt %1</translation>
    </message>
    <message>
        <source>An effect: %1</source>
        <translation>Ein Effekt: %1</translation>
    </message>
    <message>
        <source>Sensitivities and correlations</source>
        <translation>Empfindlichkeiten und Korrelationen</translation>
    </message>
    <message>
        <source>Sensitivities</source>
        <translation>Empfindlichkeiten</translation>
    </message>
    <message>
        <source>How far each trace moves with each parameter, and which parameters the recordings tell hardly apart</source>
        <translation>Wie weit sich jede Kurve mit jedem Parameter bewegt, und welche Parameter die Aufzeichnungen kaum unterscheiden</translation>
    </message>
    <message>
        <source>Head of the report …</source>
        <translation>Kopf des Berichts …</translation>
    </message>
    <message>
        <source>Title, test object, author, date, logo and sections of the reports of this study</source>
        <translation>Titel, Prüfling, Verfasser, Datum, Logo und Abschnitte der Berichte dieser Studie</translation>
    </message>
    <message>
        <source>Find in the study …</source>
        <translation>In der Studie suchen …</translation>
    </message>
    <message>
        <source>Components, parameters, signals, recordings, effects that were tried, runs and texts</source>
        <translation>Komponenten, Parameter, Signale, Aufzeichnungen, geprüfte Effekte, Läufe und Texte</translation>
    </message>
    <message>
        <source>Add a picture to the diagram</source>
        <translation>Dem Diagramm ein Bild hinzufügen</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.bmp *.gif *.svg)</source>
        <translation>Bilder (*.png *.jpg *.jpeg *.bmp *.gif *.svg)</translation>
    </message>
    <message>
        <source>%1 cannot be written: save the study under another name.</source>
        <translation>%1 lässt sich nicht schreiben: Die Studie unter einem anderen Namen sichern.</translation>
    </message>
</context>
<context>
    <name>MainWindowFiles</name>
    <message>
        <source>Unsaved changes</source>
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>%1 has changes that are not saved.</source>
        <translation>%1 hat Änderungen, die nicht gespeichert sind.</translation>
    </message>
    <message>
        <source>Nothing was opened yet</source>
        <translation>Noch nichts geöffnet</translation>
    </message>
    <message>
        <source>Import a measurement</source>
        <translation>Eine Messung importieren</translation>
    </message>
    <message>
        <source>Measurements (*.csv *.txt *.tsv *.dat *.mf4 *.mdf *.mat *.tdms *.xlsx)</source>
        <translation>Messungen (*.csv *.txt *.tsv *.dat *.mf4 *.mdf *.mat *.tdms *.xlsx)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>Open a study</source>
        <translation>Eine Studie öffnen</translation>
    </message>
    <message>
        <source>Studies (*.analogon study.json)</source>
        <translation>Studien (*.analogon study.json)</translation>
    </message>
    <message>
        <source>Studies (*.analogon)</source>
        <translation>Studien (*.analogon)</translation>
    </message>
    <message>
        <source>Write the report into a directory</source>
        <translation>Den Bericht in ein Verzeichnis schreiben</translation>
    </message>
    <message>
        <source>%1 report</source>
        <translation>%1 Bericht</translation>
    </message>
    <message>
        <source>Writing the report</source>
        <translation>Bericht schreiben</translation>
    </message>
    <message>
        <source>Report written to %1/report.html, but no report.pdf: see the messages.</source>
        <translation>Bericht nach %1/report.html geschrieben, aber kein report.pdf: siehe Meldungen.</translation>
    </message>
    <message>
        <source>Report written to %1/report.html.</source>
        <translation>Bericht in %1/report.html geschrieben.</translation>
    </message>
    <message>
        <source>No report written: see the messages.</source>
        <translation>Kein Bericht geschrieben: siehe Meldungen.</translation>
    </message>
    <message>
        <source>Locate the file of %1</source>
        <translation>Die Datei von %1 suchen</translation>
    </message>
</context>
<context>
    <name>MeasurementPanel</name>
    <message>
        <source>No further column fits by unit and name: choose it in the list, by a double click.</source>
        <translation>Keine weitere Spalte passt nach Einheit und Name: In der Liste durch Doppelklick wählen.</translation>
    </message>
    <message>
        <source>Every input and output has its column already.</source>
        <translation>Jeder Ein- und Ausgang hat schon seine Spalte.</translation>
    </message>
    <message>
        <source>The model has no input and no output yet: insert a RealInput for what drives it, a RealOutput for what it is compared with.</source>
        <translation>Das Modell hat noch keinen Ein- und keinen Ausgang: Ein RealInput steht für das, was es antreibt, ein RealOutput für das, womit es verglichen wird.</translation>
    </message>
    <message>
        <source> or </source>
        <translation> oder </translation>
    </message>
    <message>
        <source>%1?</source>
        <translation>%1?</translation>
    </message>
    <message>
        <source>Left out until this is mended:</source>
        <translation>Ausgelassen, bis dies behoben ist:</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>Column %1 of %2</source>
        <translation>Spalte %1 von %2</translation>
    </message>
    <message>
        <source>
scaled by %1</source>
        <translation>
mal %1</translation>
    </message>
    <message>
        <source>
shifted by %1</source>
        <translation>
verschoben um %1</translation>
    </message>
    <message>
        <source>
weight %1</source>
        <translation>
Gewicht %1</translation>
    </message>
    <message>
        <source>%1 samples</source>
        <translation>%1 Werte</translation>
    </message>
    <message>
        <source>not mapped</source>
        <translation>nicht zugeordnet</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>Spalte</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>Import …</source>
        <translation>Importieren …</translation>
    </message>
    <message>
        <source>Add a recording to the study</source>
        <translation>Der Studie eine Aufzeichnung hinzufügen</translation>
    </message>
    <message>
        <source>Propose mapping</source>
        <translation>Zuordnen</translation>
    </message>
    <message>
        <source>Give signals without a column the one that fits by unit and name</source>
        <translation>Signalen ohne Spalte die geben, die nach Einheit und Name passt</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>%1 zuordnen</translation>
    </message>
    <message>
        <source>Use to fit</source>
        <translation>Zur Anpassung verwenden</translation>
    </message>
    <message>
        <source>Use to validate</source>
        <translation>Zur Validierung verwenden</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alles</translation>
    </message>
    <message>
        <source>Set the range</source>
        <translation>Bereich setzen</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Used to fit and to choose effects</source>
        <translation>Dient zum Anpassen und zum Wählen von Effekten</translation>
    </message>
    <message>
        <source>Only reported; never used to fit or to choose</source>
        <translation>Wird nur berichtet; nie zum Anpassen oder Wählen verwendet</translation>
    </message>
    <message>
        <source>Input of the model</source>
        <translation>Eingang des Modells</translation>
    </message>
    <message>
        <source>Output of the model</source>
        <translation>Ausgang des Modells</translation>
    </message>
    <message>
        <source>Drag a column here, or double-click and choose one</source>
        <translation>Eine Spalte hierher ziehen, oder doppelklicken und eine wählen</translation>
    </message>
    <message>
        <source>not used</source>
        <translation>unbenutzt</translation>
    </message>
    <message>
        <source>Kept: the search for effects may use it as a cause</source>
        <translation>Bleibt erhalten: Die Suche nach Effekten kann sie als Ursache nutzen</translation>
    </message>
    <message>
        <source>range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Double-click and type from and to, in seconds</source>
        <translation>Doppelklicken und von und bis in Sekunden eingeben</translation>
    </message>
    <message>
        <source>Drop a measurement file on the window, or press Import.
Its columns are then mapped to the inputs and outputs of the model.</source>
        <translation>Eine Messdatei auf das Fenster ziehen oder „Importieren“ drücken.
Ihre Spalten werden dann den Ein- und Ausgängen des Modells zugeordnet.</translation>
    </message>
    <message>
        <source>The measurements of the open study appear here.</source>
        <translation>Hier erscheinen die Messungen der offenen Studie.</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>Uhr</translation>
    </message>
    <message>
        <source>How far the clock of this channel's logger is ahead of the others</source>
        <translation>Um wie viel die Uhr des Loggers dieses Kanals den anderen vorgeht</translation>
    </message>
    <message>
        <source>: seconds, or fit to find it. The result is among the parameters.</source>
        <translation>: Sekunden, oder „anpassen“, um es zu finden. Das Ergebnis steht bei den Parametern.</translation>
    </message>
    <message>
        <source>, in seconds</source>
        <translation>, in Sekunden</translation>
    </message>
    <message>
        <source>held</source>
        <translation>gehalten</translation>
    </message>
    <message>
        <source>
held: each value lasts until the next sample</source>
        <translation>
gehalten: Jeder Wert gilt bis zum nächsten Abtastwert</translation>
    </message>
    <message>
        <source>Hold %1 between its samples</source>
        <translation>%1 zwischen den Abtastwerten halten</translation>
    </message>
    <message>
        <source>Join the samples of %1</source>
        <translation>Abtastwerte von %1 verbinden</translation>
    </message>
    <message>
        <source>Held between its samples</source>
        <translation>Zwischen den Abtastwerten gehalten</translation>
    </message>
    <message>
        <source>Straight between its samples</source>
        <translation>Gerade zwischen den Abtastwerten</translation>
    </message>
    <message>
        <source>Set the clock of %1</source>
        <translation>Uhr von %1 setzen</translation>
    </message>
    <message>
        <source>Set the clock …</source>
        <translation>Uhr setzen …</translation>
    </message>
    <message>
        <source>Compare with other recordings</source>
        <translation>Mit anderen Messungen vergleichen</translation>
    </message>
    <message>
        <source>Show the values</source>
        <translation>Werte zeigen</translation>
    </message>
    <message>
        <source>Double-click or Enter shows the values</source>
        <translation>Doppelklick oder Eingabe zeigt die Werte</translation>
    </message>
    <message>
        <source>Locate the file …</source>
        <translation>Datei suchen …</translation>
    </message>
    <message>
        <source>Locate %1</source>
        <translation>%1 als Datei nehmen</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 lesen</translation>
    </message>
    <message>
        <source>Clear the check box to leave the recording out of all work</source>
        <translation>Haken entfernen, um die Aufzeichnung überall auszulassen</translation>
    </message>
    <message>
        <source>Left out of all work; set the check box to take it in</source>
        <translation>Überall ausgelassen; Haken setzen, um sie einzubeziehen</translation>
    </message>
    <message>
        <source>Double-click or Enter looks for the file</source>
        <translation>Doppelklick oder Eingabe sucht die Datei</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>All recordings as a table: sort them, edit role and weight, fit some of them alone</source>
        <translation>Alle Aufzeichnungen als Tabelle: sortieren, Rolle und Gewicht ändern, einige allein anpassen</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Set the unit …</source>
        <translation>Einheit setzen …</translation>
    </message>
    <message>
        <source>Set the unit of %1</source>
        <translation>Einheit von %1 setzen</translation>
    </message>
    <message>
        <source>In which the column is written, where it is not as its file says</source>
        <translation>In der die Spalte geschrieben ist, wo es nicht die ist, die ihre Datei nennt</translation>
    </message>
    <message>
        <source>As the file says</source>
        <translation>Wie die Datei sagt</translation>
    </message>
    <message>
        <source>Told here, not by the file</source>
        <translation>Hier gesagt, nicht von der Datei</translation>
    </message>
    <message>
        <source>%1 cannot be converted to %2, the unit of the model.</source>
        <translation>%1 lässt sich nicht in %2, die Einheit des Modells, umrechnen.</translation>
    </message>
    <message>
        <source>Put into the model as a source</source>
        <translation>Als Quelle ins Modell setzen</translation>
    </message>
</context>
<context>
    <name>MessagePanel</name>
    <message>
        <source>Click to see %1</source>
        <translation>Klicken, um %1 zu sehen</translation>
    </message>
    <message>
        <source>No messages. What is wrong or worth knowing is listed here; a click leads to the place.</source>
        <translation>Keine Meldungen. Hier steht, was falsch oder wissenswert ist; ein Klick führt an die Stelle.</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Click to see the place</source>
        <translation>Klicken, um die Stelle zu sehen</translation>
    </message>
</context>
<context>
    <name>OutputPlot</name>
    <message>
        <source>Click to hide or show this trace</source>
        <translation>Klicken, um diese Kurve zu verbergen oder zu zeigen</translation>
    </message>
    <message>
        <source>measured − simulated</source>
        <translation>gemessen − simuliert</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>Δ %1 s</source>
        <translation>Δ %1 s</translation>
    </message>
    <message>
        <source>A and B saw different measurements: that of B is shown</source>
        <translation>A und B hatten verschiedene Messungen: Gezeigt ist die von B</translation>
    </message>
    <message>
        <source>A and B saw different parts of the recording</source>
        <translation>A und B hatten verschiedene Teile der Aufzeichnung</translation>
    </message>
    <message>
        <source>The traces of %1 were not kept</source>
        <translation>Die Kurven von %1 wurden nicht aufbewahrt</translation>
    </message>
</context>
<context>
    <name>ParameterModel</name>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>at min</source>
        <translation>an unterer Grenze</translation>
    </message>
    <message>
        <source>at max</source>
        <translation>an oberer Grenze</translation>
    </message>
    <message>
        <source>  not determined</source>
        <translation>  nicht bestimmt</translation>
    </message>
    <message>
        <source>The fit ran into the bound: it wants a value beyond. Widen the bound, or ask what the model lacks.</source>
        <translation>Die Anpassung stößt an die Grenze: Der beste Wert liegt jenseits davon. Grenze erweitern oder nach dem suchen, was dem Modell fehlt.</translation>
    </message>
    <message>
        <source>The data do not determine this value on its own.</source>
        <translation>Die Daten allein bestimmen diesen Wert nicht.</translation>
    </message>
    <message>
        <source>
Relative standard error %1 %</source>
        <translation>
Relativer Standardfehler %1 %</translation>
    </message>
    <message>
        <source>Where the value lies between its bounds; the broad part is its standard error</source>
        <translation>Wo der Wert zwischen seinen Grenzen liegt; der breite Teil ist sein Standardfehler</translation>
    </message>
    <message>
        <source>Double-click to see the value in another unit</source>
        <translation>Doppelklick zeigt den Wert in einer anderen Einheit</translation>
    </message>
    <message>
        <source>Checked parameters are fitted</source>
        <translation>Angehakte Parameter werden angepasst</translation>
    </message>
    <message>
        <source>Where a run starts from</source>
        <translation>Wovon ein Lauf ausgeht</translation>
    </message>
    <message>
        <source>Estimate ± standard error of the last run</source>
        <translation>Schätzwert ± Standardfehler des letzten Laufs</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>Min</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Max</translation>
    </message>
    <message>
        <source>Bounds</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>Free the bound of %1</source>
        <translation>Grenze von %1 aufheben</translation>
    </message>
    <message>
        <source>Set the bound of %1</source>
        <translation>Grenze von %1 setzen</translation>
    </message>
    <message>
        <source>Fit %1</source>
        <translation>%1 anpassen</translation>
    </message>
    <message>
        <source>Fix %1</source>
        <translation>%1 festhalten</translation>
    </message>
    <message>
        <source>Prior</source>
        <translation>Vorwissen</translation>
    </message>
    <message>
        <source>How far the clock of the logger of %1 is ahead of the others</source>
        <translation>Um wie viel die Uhr des Loggers von %1 den anderen vorgeht</translation>
    </message>
    <message>
        <source>
%1 standard deviations from what was known beforehand</source>
        <translation>
%1 Standardabweichungen vom Vorwissen</translation>
    </message>
    <message>
        <source>What is known beforehand: mean ± standard deviation. It counts as one more measured value; empty: nothing is known.</source>
        <translation>Was man vorher weiß: Mittelwert ± Standardabweichung. Es zählt wie ein weiterer Messwert; leer: nichts ist bekannt.</translation>
    </message>
    <message>
        <source>Forget what is known of %1</source>
        <translation>Vorwissen über %1 verwerfen</translation>
    </message>
    <message>
        <source>Set what is known of %1</source>
        <translation>Vorwissen über %1 setzen</translation>
    </message>
</context>
<context>
    <name>ParameterPanel</name>
    <message>
        <source>Give a prior …</source>
        <translation>Vorwissen angeben …</translation>
    </message>
    <message>
        <source>Place a block: its parameters appear here.</source>
        <translation>Einen Block einsetzen: Seine Parameter erscheinen hier.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Search parameters</source>
        <translation>Parameter suchen</translation>
    </message>
    <message>
        <source>Show the parameters of all components</source>
        <translation>Parameter aller Komponenten zeigen</translation>
    </message>
    <message>
        <source>Fitted only</source>
        <translation>Nur angepasste</translation>
    </message>
    <message>
        <source>Hide parameters that are not fitted</source>
        <translation>Parameter verbergen, die nicht angepasst werden</translation>
    </message>
    <message>
        <source>The parameters of the open study appear here.</source>
        <translation>Hier erscheinen die Parameter der offenen Studie.</translation>
    </message>
    <message>
        <source>No parameter matches. Clear the search or the filter.</source>
        <translation>Kein Parameter passt. Suche oder Filter leeren.</translation>
    </message>
    <message>
        <source>The model has an error: the messages say where.</source>
        <translation>Das Modell hat einen Fehler: Die Meldungen sagen, wo.</translation>
    </message>
    <message>
        <source>No block of this model has parameters.</source>
        <translation>Kein Block dieses Modells hat Parameter.</translation>
    </message>
    <message>
        <source>mean ± std</source>
        <translation>Mittelwert ± Std.-Abw.</translation>
    </message>
    <message>
        <source>The model has an error (see the messages): shown is what its declarations tell.</source>
        <translation>Das Modell hat einen Fehler (siehe Meldungen): Gezeigt ist, was seine Deklarationen sagen.</translation>
    </message>
    <message>
        <source>Not connected yet: shown is what the declarations tell.</source>
        <translation>Noch nicht verbunden: Gezeigt wird, was die Deklarationen sagen.</translation>
    </message>
    <message>
        <source>The text of the model cannot be read (see the messages): shown is what it told last.</source>
        <translation>Der Text des Modells ist nicht lesbar (siehe Meldungen): Gezeigt ist, was er zuletzt gesagt hat.</translation>
    </message>
</context>
<context>
    <name>PlotPanel</name>
    <message>
        <source>The model has an error (see the messages): measured and simulated traces appear here once it has none. Signals shows what was recorded at once.</source>
        <translation>Das Modell hat einen Fehler (siehe Meldungen): Sobald er behoben ist, erscheinen hier gemessene und simulierte Verläufe. „Signale“ zeigt das Aufgezeichnete sofort.</translation>
    </message>
    <message>
        <source>The model is not finished: once its parts are connected and its inputs and outputs have columns, measured and simulated traces appear here. Signals shows what was recorded at once.</source>
        <translation>Das Modell ist nicht fertig: Sobald seine Teile verbunden sind und seine Ein- und Ausgänge Spalten haben, erscheinen hier gemessene und simulierte Verläufe. „Signale“ zeigt das Aufgezeichnete sofort.</translation>
    </message>
    <message>
        <source>fitted as given</source>
        <translation>wie gegeben angepasst</translation>
    </message>
    <message>
        <source>The model has an error, and no measurement can be read.</source>
        <translation>Das Modell hat einen Fehler, und keine Messung ist lesbar.</translation>
    </message>
    <message>
        <source>best so far</source>
        <translation>bisher bestes</translation>
    </message>
    <message>
        <source>tried</source>
        <translation>versucht</translation>
    </message>
    <message>
        <source>There is nothing to fit yet: check parameters in the list.</source>
        <translation>Noch gibt es nichts anzupassen: Parameter in der Liste anhaken.</translation>
    </message>
    <message>
        <source>All values are those of the library yet: check the parameters that are to be found, and enter those that are known.</source>
        <translation>Noch sind alle Werte die der Bibliothek: gesuchte Parameter anhaken und bekannte eintragen.</translation>
    </message>
    <message>
        <source>%1 does nothing there that the data show.</source>
        <translation>%1 bewirkt dort nichts, was die Daten zeigen.</translation>
    </message>
    <message>
        <source>Experiments</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Traces</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Residuum</translation>
    </message>
    <message>
        <source>What the residual looks like: distribution, memory, what it moves with</source>
        <translation>Wie das Residuum aussieht: Verteilung, Gedächtnis, Zusammenhang mit anderen Größen</translation>
    </message>
    <message>
        <source>Export …</source>
        <translation>Exportieren …</translation>
    </message>
    <message>
        <source>What is shown as PNG or SVG, its numbers as CSV</source>
        <translation>Das Gezeigte als PNG oder SVG, seine Zahlen als CSV</translation>
    </message>
    <message>
        <source>Trim</source>
        <translation>Zuschneiden</translation>
    </message>
    <message>
        <source>Then drag over the part of the recording that is to be used</source>
        <translation>Danach über den Teil der Aufzeichnung ziehen, der verwendet werden soll</translation>
    </message>
    <message>
        <source>Use all</source>
        <translation>Alles verwenden</translation>
    </message>
    <message>
        <source>Use the whole recording again</source>
        <translation>Wieder die ganze Aufzeichnung verwenden</translation>
    </message>
    <message>
        <source>Open a study to see its measurements here.</source>
        <translation>Eine Studie öffnen, um hier ihre Messungen zu sehen.</translation>
    </message>
    <message>
        <source>Simulating the model as it stands …</source>
        <translation>Das Modell wird simuliert, wie es ist …</translation>
    </message>
    <message>
        <source>before</source>
        <translation>vorher</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>simuliert</translation>
    </message>
    <message>
        <source>after</source>
        <translation>nachher</translation>
    </message>
    <message>
        <source>Drag over the part of the recording that is to be used.</source>
        <translation>Über den Teil der Aufzeichnung ziehen, der verwendet werden soll.</translation>
    </message>
    <message>
        <source>Trim %1</source>
        <translation>%1 zuschneiden</translation>
    </message>
    <message>
        <source>Use all of %1</source>
        <translation>%1 ganz verwenden</translation>
    </message>
    <message>
        <source>Export what is shown</source>
        <translation>Das Gezeigte exportieren</translation>
    </message>
    <message>
        <source>Picture (*.png)</source>
        <translation>Bild (*.png)</translation>
    </message>
    <message>
        <source>Drawing (*.svg)</source>
        <translation>Zeichnung (*.svg)</translation>
    </message>
    <message>
        <source>Numbers (*.csv)</source>
        <translation>Zahlen (*.csv)</translation>
    </message>
    <message>
        <source>There is nothing to export yet.</source>
        <translation>Es gibt noch nichts zu exportieren.</translation>
    </message>
    <message>
        <source>Exported to %1.</source>
        <translation>Nach %1 exportiert.</translation>
    </message>
    <message>
        <source>End comparison</source>
        <translation>Vergleich beenden</translation>
    </message>
    <message>
        <source>Show the traces of the study again, instead of two runs over each other</source>
        <translation>Wieder die Kurven der Studie zeigen, nicht zwei Läufe übereinander</translation>
    </message>
    <message>
        <source>Import a measurement and map its columns: measured and simulated traces then appear here. Simulate (F4) shows the model by itself.</source>
        <translation>Eine Messung importieren und ihre Spalten zuordnen: Dann erscheinen hier gemessene und simulierte Verläufe. „Simulieren“ (F4) zeigt das Modell für sich.</translation>
    </message>
    <message>
        <source>Map a column of the recording to an output of the model, among the measurements: measured and simulated traces then appear here. Signals shows what was recorded at once.</source>
        <translation>Unter den Messungen eine Spalte der Aufzeichnung einem Ausgang des Modells zuordnen: Dann erscheinen hier gemessene und simulierte Verläufe. „Signale“ zeigt sofort, was aufgezeichnet wurde.</translation>
    </message>
</context>
<context>
    <name>QuestionCard</name>
    <message>
        <source>another unit</source>
        <translation>andere Einheit</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Take this unit</source>
        <translation>Diese Einheit nehmen</translation>
    </message>
    <message>
        <source>The rows under each reading</source>
        <translation>Die Zeilen bei jeder Lesart</translation>
    </message>
    <message>
        <source>0.001 s, or 1 kHz</source>
        <translation>0,001 s oder 1 kHz</translation>
    </message>
    <message>
        <source>Time between two rows</source>
        <translation>Zeit zwischen zwei Zeilen</translation>
    </message>
    <message>
        <source>Take this time</source>
        <translation>Diese Zeit nehmen</translation>
    </message>
    <message>
        <source>Or choose the column that is the time above. The time is counted from the first row.</source>
        <translation>Oder wählen Sie oben die Spalte, die die Zeit ist. Gezählt wird von der ersten Zeile an.</translation>
    </message>
    <message>
        <source>The file does not tell. What you choose is kept with the study.</source>
        <translation>Die Datei sagt es nicht. Was Sie wählen, bleibt bei der Studie.</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>In the file</source>
        <translation>In der Datei</translation>
    </message>
</context>
<context>
    <name>ReadFields</name>
    <message>
        <source>Separator</source>
        <translation>Trennzeichen</translation>
    </message>
    <message>
        <source>comma</source>
        <translation>Komma</translation>
    </message>
    <message>
        <source>semicolon</source>
        <translation>Semikolon</translation>
    </message>
    <message>
        <source>tab</source>
        <translation>Tabulator</translation>
    </message>
    <message>
        <source>space</source>
        <translation>Leerzeichen</translation>
    </message>
    <message>
        <source>bar</source>
        <translation>Senkrechter Strich</translation>
    </message>
    <message>
        <source>Decimal sign</source>
        <translation>Dezimalzeichen</translation>
    </message>
    <message>
        <source>point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Row of units</source>
        <translation>Einheitenzeile</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>Sign between thousands</source>
        <translation>Tausenderzeichen</translation>
    </message>
    <message>
        <source>1 234 567.8 has blanks between thousands</source>
        <translation>1 234 567,8 hat Leerzeichen zwischen Tausendern</translation>
    </message>
    <message>
        <source>Several times</source>
        <translation>Mehrere Zeiten</translation>
    </message>
    <message>
        <source>Where several columns are times: which of them a channel has</source>
        <translation>Wo mehrere Spalten Zeiten sind: welche davon ein Kanal hat</translation>
    </message>
    <message>
        <source>the first for all</source>
        <translation>die erste für alle</translation>
    </message>
    <message>
        <source>the one on the left</source>
        <translation>die links davon</translation>
    </message>
    <message>
        <source>the one on the right</source>
        <translation>die rechts davon</translation>
    </message>
    <message>
        <source>apostrophe</source>
        <translation>Apostroph</translation>
    </message>
    <message>
        <source>Lines to skip</source>
        <translation>Zeilen zu überspringen</translation>
    </message>
    <message>
        <source>Lines in front of the header that are not looked at</source>
        <translation>Zeilen vor dem Kopf, die nicht angesehen werden</translation>
    </message>
    <message>
        <source>Rows of the header</source>
        <translation>Zeilen des Kopfes</translation>
    </message>
    <message>
        <source>The row of units included; 0: there is none</source>
        <translation>Mit der Zeile der Einheiten; 0: es gibt keinen</translation>
    </message>
    <message>
        <source>Form of the time</source>
        <translation>Form der Zeit</translation>
    </message>
    <message>
        <source>How dates and clocks are written: %d.%m.%Y %H:%M:%S. Of rows without a time the step from one to the next: 0.001 s or 1 kHz. Of a time without a unit the unit: ms</source>
        <translation>Wie Datum und Uhrzeit geschrieben sind: %d.%m.%Y %H:%M:%S. Bei Zeilen ohne Zeit der Schritt von einer zur nächsten: 0,001 s oder 1 kHz. Bei einer Zeit ohne Einheit die Einheit: ms</translation>
    </message>
    <message>
        <source>Time zone</source>
        <translation>Zeitzone</translation>
    </message>
    <message>
        <source>Of stamps that do not tell it</source>
        <translation>Von Zeitstempeln, die sie nicht nennen</translation>
    </message>
    <message>
        <source>Letters</source>
        <translation>Zeichensatz</translation>
    </message>
    <message>
        <source>How the bytes of the file are letters</source>
        <translation>Wie die Bytes der Datei Buchstaben sind</translation>
    </message>
    <message>
        <source>More about how it is written</source>
        <translation>Mehr dazu, wie sie geschrieben ist</translation>
    </message>
</context>
<context>
    <name>Recovery</name>
    <message>
        <source>Keeping a copy</source>
        <translation>Sicherungskopie</translation>
    </message>
</context>
<context>
    <name>RecoveredLine</name>
    <message>
        <source>A study that was never saved</source>
        <translation>Eine Studie, die nie gespeichert wurde</translation>
    </message>
    <message>
        <source>%1, changes of %2</source>
        <translation>%1, Änderungen vom %2</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
</context>
<context>
    <name>ReportPdf</name>
    <message>
        <source>Screening</source>
        <translation>Vorauswahl</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>What is left between model and measurement is noise. Nothing was added.</source>
        <translation>Zwischen Modell und Messung bleibt nur Rauschen. Es wurde nichts ergänzt.</translation>
    </message>
    <message>
        <source>The residual is not noise, and no effect of the library explains it.</source>
        <translation>Das Residuum ist kein Rauschen, und kein Effekt der Bibliothek erklärt es.</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>The model before and after</source>
        <translation>Das Modell vorher und nachher</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Nachher</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>anpassen</translation>
    </message>
    <message>
        <source>validate</source>
        <translation>validieren</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Kennzahl</translation>
    </message>
    <message>
        <source>ΔBIC</source>
        <translation>ΔBIC</translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation>Sicherheit</translation>
    </message>
    <message>
        <source>Held out</source>
        <translation>Zurückgehalten</translation>
    </message>
    <message>
        <source>What was tried</source>
        <translation>Was geprüft wurde</translation>
    </message>
    <message>
        <source>Effect</source>
        <translation>Effekt</translation>
    </message>
    <message>
        <source>At</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Bewertung</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>%1 lässt sich nicht schreiben.</translation>
    </message>
</context>
<context>
    <name>ResidualPlot</name>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation>Verteilung</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>Residuum</translation>
    </message>
    <message>
        <source>Autocorrelation</source>
        <translation>Autokorrelation</translation>
    </message>
    <message>
        <source>lag [samples]</source>
        <translation>Versatz [Werte]</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Residuum</translation>
    </message>
    <message>
        <source>Residual against</source>
        <translation>Residuum über</translation>
    </message>
    <message>
        <source>Left: how the residual is distributed, with the normal distribution of the same spread.
Middle: how much of it is left after so many samples; white noise stays within the band.
Right: the residual against another variable; noise shows no shape.</source>
        <translation>Links: wie das Residuum verteilt ist, mit der Normalverteilung gleicher Streuung.
Mitte: wie viel davon nach so vielen Abtastwerten bleibt; weißes Rauschen bleibt im Band.
Rechts: das Residuum über einer anderen Größe; Rauschen zeigt keine Form.</translation>
    </message>
    <message>
        <source>against</source>
        <translation>über</translation>
    </message>
</context>
<context>
    <name>ResultPanel</name>
    <message>
        <source>%1 by %2</source>
        <translation>%1 durch %2</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation>Sicherheit</translation>
    </message>
    <message>
        <source>indicated</source>
        <translation>angezeigt</translation>
    </message>
    <message>
        <source>established</source>
        <translation>erwiesen</translation>
    </message>
    <message>
        <source>predicts better; structure remains</source>
        <translation>sagt besser voraus; Struktur bleibt</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Weggelassen</translation>
    </message>
    <message>
        <source>better in %1 of %2 parts</source>
        <translation>besser in %1 von %2 Teilen</translation>
    </message>
    <message>
        <source>Error of parts of the measurement that were left out of the fit in turn, without the effect and with it</source>
        <translation>Fehler von Teilen der Messung, die der Reihe nach aus der Anpassung weggelassen wurden, ohne den Effekt und mit ihm</translation>
    </message>
    <message>
        <source>Another value would explain as much: %1.</source>
        <translation>Ein anderer Wert würde ebenso viel erklären: %1.</translation>
    </message>
    <message>
        <source>The error cannot be made smaller by changing the fitted parameters.</source>
        <translation>Durch Ändern der angepassten Parameter lässt sich der Fehler nicht weiter verkleinern.</translation>
    </message>
    <message>
        <source>Fit stopped</source>
        <translation>Anpassung angehalten</translation>
    </message>
    <message>
        <source>The best parameters so far are shown.</source>
        <translation>Gezeigt sind die bisher besten Parameter.</translation>
    </message>
    <message>
        <source>Parameters fitted</source>
        <translation>Parameter angepasst</translation>
    </message>
    <message>
        <source>Fitted, with %1 at a bound</source>
        <translation>Angepasst, %1 an einer Grenze</translation>
    </message>
    <message>
        <source>Within the bounds the error cannot be made smaller; beyond them it could be.</source>
        <translation>Innerhalb der Grenzen lässt sich der Fehler nicht weiter verkleinern; jenseits davon wohl.</translation>
    </message>
    <message>
        <source>Fit did not converge</source>
        <translation>Anpassung nicht konvergiert</translation>
    </message>
    <message>
        <source>Search stopped</source>
        <translation>Suche angehalten</translation>
    </message>
    <message>
        <source>What was found until then is shown; the rest was not tried.</source>
        <translation>Gezeigt ist, was bis dahin gefunden war; der Rest wurde nicht versucht.</translation>
    </message>
    <message>
        <source>%1 effects</source>
        <translation>%1 Effekte</translation>
    </message>
    <message>
        <source>The model is adequate</source>
        <translation>Das Modell genügt</translation>
    </message>
    <message>
        <source>With it, refitted, what is left is noise.</source>
        <translation>Damit und neu angepasst bleibt nur Rauschen.</translation>
    </message>
    <message>
        <source>With it, refitted, some structure remains that no candidate explains.</source>
        <translation>Damit und neu angepasst bleibt Struktur, die kein Kandidat erklärt.</translation>
    </message>
    <message>
        <source>No effect was looked for</source>
        <translation>Es wurde kein Effekt gesucht</translation>
    </message>
    <message>
        <source>A recording is not what it says</source>
        <translation>Eine Aufzeichnung ist nicht, was sie angibt</translation>
    </message>
    <message>
        <source>Unexplained structure</source>
        <translation>Unerklärte Struktur</translation>
    </message>
    <message>
        <source>%1 by channel %2</source>
        <translation>%1 durch Kanal %2</translation>
    </message>
    <message>
        <source>output %1</source>
        <translation>Ausgang %1</translation>
    </message>
    <message>
        <source>input %1</source>
        <translation>Eingang %1</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>gewählt</translation>
    </message>
    <message>
        <source>equivalent</source>
        <translation>gleichwertig</translation>
    </message>
    <message>
        <source>weaker</source>
        <translation>schwächer</translation>
    </message>
    <message>
        <source>not significant</source>
        <translation>nicht signifikant</translation>
    </message>
    <message>
        <source>absorbed</source>
        <translation>aufgenommen</translation>
    </message>
    <message>
        <source>wrong sign</source>
        <translation>falsches Vorzeichen</translation>
    </message>
    <message>
        <source>fails on held-out data</source>
        <translation>versagt auf zurückgehaltenen Daten</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>misslungen</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bei %2</translation>
    </message>
    <message>
        <source>&lt;b&gt;Fit&lt;/b&gt; estimates the parameters.&lt;br&gt;&lt;b&gt;Discover&lt;/b&gt; also asks what the model lacks, adds it and shows the evidence here.</source>
        <translation>&lt;b&gt;Anpassen&lt;/b&gt; schätzt die Parameter.&lt;br&gt;&lt;b&gt;Effekt suchen&lt;/b&gt; fragt auch, was dem Modell fehlt, und zeigt hier die Belege.</translation>
    </message>
    <message>
        <source>Results appear here once a study is open.</source>
        <translation>Ergebnisse erscheinen hier, sobald eine Studie offen ist.</translation>
    </message>
    <message>
        <source>The study has been changed since. Run again to see what holds now.</source>
        <translation>Die Studie wurde seither geändert. Ein neuer Lauf zeigt, was jetzt gilt.</translation>
    </message>
    <message>
        <source>Write fitted values into the model</source>
        <translation>Angepasste Werte ins Modell schreiben</translation>
    </message>
    <message>
        <source>Add to the model</source>
        <translation>Ins Modell aufnehmen</translation>
    </message>
    <message>
        <source>Write fitted values</source>
        <translation>Angepasste Werte schreiben</translation>
    </message>
    <message>
        <source>Add what was found</source>
        <translation>Gefundenes aufnehmen</translation>
    </message>
    <message>
        <source>Root mean square error in percent of the measured range, over all outputs</source>
        <translation>Effektivwert des Fehlers in Prozent des gemessenen Bereichs, über alle Ausgänge</translation>
    </message>
    <message>
        <source>Evidence</source>
        <translation>Belege</translation>
    </message>
    <message>
        <source>fitted experiments</source>
        <translation>zur Anpassung verwendete Versuche</translation>
    </message>
    <message>
        <source>Over the fitted experiments</source>
        <translation>Über die zur Anpassung verwendeten Versuche</translation>
    </message>
    <message>
        <source>signal to noise, squared</source>
        <translation>Quadrat des Signal-Rausch-Verhältnisses</translation>
    </message>
    <message>
        <source>Squared signal-to-noise ratio of what the finished model misses when it is refitted without the effect</source>
        <translation>Quadrat des Signal-Rausch-Verhältnisses dessen, was dem fertigen Modell fehlt, wenn es ohne den Effekt neu angepasst wird</translation>
    </message>
    <message>
        <source>negative: gains more than it costs</source>
        <translation>negativ: der Effekt bringt mehr, als er kostet</translation>
    </message>
    <message>
        <source>Of the finished model against the same refitted without the effect; negative: it gains more than its parameters cost</source>
        <translation>Des fertigen Modells gegen dasselbe, ohne den Effekt neu angepasst; negativ: Er bringt mehr, als seine Parameter kosten</translation>
    </message>
    <message>
        <source>Each with its figures in the round in which it was tried; those above are of the finished model.</source>
        <translation>Jeder Effekt mit den Zahlen der Runde, in der er geprüft wurde; die Zahlen weiter oben gelten für das fertige Modell.</translation>
    </message>
    <message>
        <source>Screening</source>
        <translation>Vorauswahl</translation>
    </message>
    <message>
        <source>How much of the residual the effect would explain, estimated before any refit: signal to noise, squared</source>
        <translation>Wie viel vom Residuum der Effekt erklären würde, geschätzt vor jeder Anpassung: Quadrat des Signal-Rausch-Verhältnisses</translation>
    </message>
    <message>
        <source>Of the refit with the effect, beside what the model held in that round; empty: it was not refitted</source>
        <translation>Der Anpassung mit dem Effekt, neben dem, was das Modell in jener Runde enthielt; leer: wurde nicht angepasst</translation>
    </message>
    <message>
        <source>+1: holds on data left out; −1: fails</source>
        <translation>+1: gilt auch in zurückgehaltenen Daten; −1: nicht</translation>
    </message>
    <message>
        <source>+1: the gain holds on data left out of the fit; −1: it does not</source>
        <translation>+1: Der Gewinn gilt auch auf zurückgehaltenen Daten; −1: er gilt dort nicht</translation>
    </message>
    <message>
        <source>This data cannot tell it from: %1.</source>
        <translation>Diese Daten können es nicht unterscheiden von: %1.</translation>
    </message>
    <message>
        <source>Show in the diagram</source>
        <translation>Im Diagramm zeigen</translation>
    </message>
    <message>
        <source>What remains on %1</source>
        <translation>Was an %1 übrig bleibt</translation>
    </message>
    <message>
        <source>Between %1 and %2 s</source>
        <translation>Zwischen %1 und %2 s</translation>
    </message>
    <message>
        <source> of %1</source>
        <translation> von %1</translation>
    </message>
    <message>
        <source>, acting at %1</source>
        <translation>, wirkend an %1</translation>
    </message>
    <message>
        <source>, or as well at %1</source>
        <translation>, oder ebenso an %1</translation>
    </message>
    <message>
        <source>It moves with %1.</source>
        <translation>Es hängt zusammen mit %1.</translation>
    </message>
    <message>
        <source>Next experiment</source>
        <translation>Nächster Versuch</translation>
    </message>
    <message>
        <source>Try the marked effect</source>
        <translation>Markierten Effekt erproben</translation>
    </message>
    <message>
        <source>Fits the model with this effect and shows its traces; the result is kept among the runs</source>
        <translation>Passt das Modell mit diesem Effekt an und zeigt seine Kurven; das Ergebnis bleibt bei den Läufen erhalten</translation>
    </message>
    <message>
        <source>Add the equation to the model</source>
        <translation>Die Gleichung ins Modell aufnehmen</translation>
    </message>
    <message>
        <source>Add the equations to the model</source>
        <translation>Die Gleichungen ins Modell aufnehmen</translation>
    </message>
    <message>
        <source>Wires in what is proposed, with the values of its fit; one step, which can be undone</source>
        <translation>Verdrahtet das Vorgeschlagene mit den angepassten Werten; ein Schritt, der sich zurücknehmen lässt</translation>
    </message>
    <message>
        <source>Proposed, not added: %1</source>
        <translation>Vorgeschlagen, nicht aufgenommen: %1</translation>
    </message>
    <message>
        <source>Block %1</source>
        <translation>Block %1</translation>
    </message>
    <message>
        <source>with it the error would be %1 on fitted data</source>
        <translation>damit wäre der Fehler %1 auf angepassten Daten</translation>
    </message>
    <message>
        <source>%1 on validation data</source>
        <translation>%1 auf Validierungsdaten</translation>
    </message>
    <message>
        <source>worse than the %1 without it</source>
        <translation>schlechter als die %1 ohne sie</translation>
    </message>
    <message>
        <source>Caution</source>
        <translation>Zu beachten</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtern</translation>
    </message>
    <message>
        <source>Filter what was tried</source>
        <translation>Was erprobt wurde, filtern</translation>
    </message>
    <message>
        <source>By round</source>
        <translation>Nach Runden</translation>
    </message>
    <message>
        <source>What was tried in each round stands together</source>
        <translation>Was in derselben Runde erprobt wurde, steht zusammen</translation>
    </message>
    <message>
        <source>Round %1</source>
        <translation>Runde %1</translation>
    </message>
    <message>
        <source>Try this effect</source>
        <translation>Diesen Effekt erproben</translation>
    </message>
    <message>
        <source>With them, refitted, what is left is noise.</source>
        <translation>Damit und neu angepasst bleibt nur Rauschen.</translation>
    </message>
    <message>
        <source>With them, refitted, some structure remains that no candidate explains.</source>
        <translation>Damit und neu angepasst bleibt Struktur, die kein Kandidat erklärt.</translation>
    </message>
    <message>
        <source>Search ten times as long</source>
        <translation>Zehnmal so lange suchen</translation>
    </message>
    <message>
        <source>Discover again, with ten times the work that it had</source>
        <translation>Noch einmal suchen, mit dem Zehnfachen der Arbeit</translation>
    </message>
    <message>
        <source>Search ended at its limit of work</source>
        <translation>Suche an der Grenze ihrer Arbeit beendet</translation>
    </message>
    <message>
        <source>What it has found is shown; the rest was not tried.</source>
        <translation>Gezeigt ist, was sie gefunden hat; der Rest wurde nicht versucht.</translation>
    </message>
    <message>
        <source>Click to sort; a third click brings back the order in which they were tried</source>
        <translation>Klicken sortiert; ein dritter Klick stellt die Reihenfolge der Versuche wieder her</translation>
    </message>
    <message>
        <source>Test object</source>
        <translation>Exemplar</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>Verfasser</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
</context>
<context>
    <name>RunBar</name>
    <message>
        <source>fitting</source>
        <translation>Anpassung</translation>
    </message>
    <message>
        <source>simulating</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>looking at every effect</source>
        <translation>alle Effekte werden angesehen</translation>
    </message>
    <message>
        <source>trying</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop; the best result so far is kept (Esc)</source>
        <translation>Anhalten; das bisher beste Ergebnis bleibt (Esc)</translation>
    </message>
    <message>
        <source>Stopping …</source>
        <translation>Hält an …</translation>
    </message>
    <message>
        <source>weighing again</source>
        <translation>erneute Abwägung</translation>
    </message>
    <message>
        <source>leaving out</source>
        <translation>Weglassen</translation>
    </message>
    <message>
        <source>looking for an equation</source>
        <translation>Suche nach einer Gleichung</translation>
    </message>
    <message>
        <source>planning the next experiment</source>
        <translation>Planung des nächsten Versuchs</translation>
    </message>
    <message>
        <source>error %1 %</source>
        <translation>Fehler %1 %</translation>
    </message>
</context>
<context>
    <name>RunController</name>
    <message>
        <source>Fit</source>
        <translation>Anpassung</translation>
    </message>
    <message>
        <source>the study was changed during the run; its result does not belong to what is shown and was dropped</source>
        <translation>Die Studie wurde während des Laufs geändert; sein Ergebnis gehört nicht zu dem, was gezeigt wird, und wurde verworfen</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Discovery</source>
        <translation>Suche</translation>
    </message>
    <message>
        <source>%1 stopped.</source>
        <translation>%1 angehalten.</translation>
    </message>
    <message>
        <source>%1 failed: see the messages.</source>
        <translation>%1 misslungen: siehe Meldungen.</translation>
    </message>
    <message>
        <source>%1: the study changed meanwhile, result dropped.</source>
        <translation>%1: Die Studie wurde inzwischen geändert, das Ergebnis verworfen.</translation>
    </message>
    <message>
        <source>%1 stopped; best result so far is shown.</source>
        <translation>%1 angehalten; gezeigt ist das bisher beste Ergebnis.</translation>
    </message>
    <message>
        <source>%1 done in %2 s.</source>
        <translation>%1 fertig nach %2 s.</translation>
    </message>
    <message>
        <source>Discover ended at its limit of work; what it has found is shown.</source>
        <translation>Die Suche endete an der Grenze ihrer Arbeit; gezeigt ist, was sie gefunden hat.</translation>
    </message>
</context>
<context>
    <name>StartPage</name>
    <message>
        <source>Physical models from test-bench measurements: fit the parameters, find the effect the model lacks, see the evidence.</source>
        <translation>Physikalische Modelle aus Prüfstandsmessungen: Parameter anpassen, den fehlenden Effekt finden, die Belege sehen.</translation>
    </message>
    <message>
        <source>Open a study …</source>
        <translation>Studie öffnen …</translation>
    </message>
    <message>
        <source>New study</source>
        <translation>Neue Studie</translation>
    </message>
    <message>
        <source>Or drop a study (a directory, its study.json, an .analogon file) or recordings here</source>
        <translation>Oder eine Studie (Verzeichnis, study.json oder .analogon-Datei) oder Aufzeichnungen hierher ziehen</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>Recovered work</source>
        <translation>Wiederhergestellte Arbeit</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Zuletzt</translation>
    </message>
</context>
<context>
    <name>TextView</name>
    <message>
        <source>Model text</source>
        <translation>Modelltext</translation>
    </message>
</context>
<context>
    <name>Breadcrumb</name>
    <message>
        <source>Where the diagram lies in the model</source>
        <translation>Wo das Diagramm im Modell liegt</translation>
    </message>
    <message>
        <source>Back to this diagram</source>
        <translation>Zurück zu diesem Diagramm</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Set the unit of %1</source>
        <translation>Einheit von %1 setzen</translation>
    </message>
</context>
<context>
    <name>Examples</name>
    <message>
        <source>Heating of an exhaust-gas sensor</source>
        <translation>Aufheizen einer Abgassonde</translation>
    </message>
    <message>
        <source>A planar lambda sensor must be hot before it measures, so it carries an electric heater. What is recorded is the voltage at the heater, its current, and the temperature of the exhaust gas. Since the resistance of the heater rises with its temperature, the current tells how warm the element is.</source>
        <translation>Eine planare Lambdasonde misst erst, wenn sie heiß ist: Sie hat einen Heizer. Aufgezeichnet sind seine Spannung, sein Strom und die Temperatur des Abgases. Da der Widerstand des Heizers mit seiner Temperatur steigt, verrät der Strom, wie warm das Element ist.</translation>
    </message>
    <message>
        <source>Electric water pump</source>
        <translation>Elektrische Wasserpumpe</translation>
    </message>
    <message>
        <source>A direct-current motor drives the impeller of a coolant pump. Recorded are the voltage at the motor, its current and the speed of the shaft.</source>
        <translation>Ein Gleichstrommotor treibt das Laufrad einer Kühlmittelpumpe an. Aufgezeichnet sind die Spannung am Motor, sein Strom und die Drehzahl der Welle.</translation>
    </message>
</context>
<context>
    <name>TableModel</name>
    <message>
        <source>Lines of the file</source>
        <translation>Zeilen der Datei</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>the profile of {} was not found: the model cannot be fitted again from here</source>
        <translation>das Profil von {} wurde nicht gefunden: Von hier aus lässt sich das Modell nicht noch einmal anpassen</translation>
    </message>
    <message>
        <source>the state of the campaign cannot be read</source>
        <translation>der Stand der Kampagne ist nicht lesbar</translation>
    </message>
    <message>
        <source>Start the campaign again: what is done is found in the folders of the units.</source>
        <translation>Die Kampagne erneut starten: Was fertig ist, findet sich in den Ordnern der Exemplare.</translation>
    </message>
    <message>
        <source>the file became shorter while it was read</source>
        <translation>die Datei wurde kürzer, während sie gelesen wurde</translation>
    </message>
    <message>
        <source>no unit, numbers alone</source>
        <translation>keine Einheit, nur Zahlen</translation>
    </message>
    <message>
        <source>the unit '{}' of {} is not known here</source>
        <translation>die Einheit „{}“ von {} ist hier nicht bekannt</translation>
    </message>
    <message>
        <source>: did you mean '{}'?</source>
        <translation>: Meinten Sie „{}“?</translation>
    </message>
    <message>
        <source>: did you mean '{}' or '{}'?</source>
        <translation>: Meinten Sie „{}“ oder „{}“?</translation>
    </message>
    <message>
        <source>Say it in the study: &quot;read&quot;: {{&quot;unit_names&quot;: {{&quot;{}&quot;: &quot;{}&quot;}}}}.</source>
        <translation>Sagen Sie es in der Studie: &quot;read&quot;: {{&quot;unit_names&quot;: {{&quot;{}&quot;: &quot;{}&quot;}}}}.</translation>
    </message>
    <message>
        <source>Say it at the import, where it is asked: '{}' is '{}'.</source>
        <translation>Sagen Sie es beim Import, wo danach gefragt wird: „{}“ ist „{}“.</translation>
    </message>
    <message>
        <source>Which unit is '{}', of {}?</source>
        <translation>Welche Einheit ist „{}“, bei {}?</translation>
    </message>
    <message>
        <source>{} and {} more</source>
        <translation>{} und {} weiteren</translation>
    </message>
    <message>
        <source>an object {{unit of the file: unit}}, as {{&quot;kpa&quot;: &quot;kPa&quot;}}</source>
        <translation>ein Objekt {{Einheit der Datei: Einheit}}, wie {{&quot;kpa&quot;: &quot;kPa&quot;}}</translation>
    </message>
    <message>
        <source>&quot;1&quot; is a number without a unit.</source>
        <translation>&quot;1&quot; ist eine Zahl ohne Einheit.</translation>
    </message>
    <message>
        <source>column '{}' is read as text: '{}' is no number</source>
        <translation>Spalte „{}“ wird als Text gelesen: „{}“ ist keine Zahl</translation>
    </message>
    <message>
        <source>the time in column '{}' falls from row to row: the newest stands first, and the rows are taken from the last one on</source>
        <translation>die Zeit in Spalte „{}“ fällt von Zeile zu Zeile: Die neueste steht vorn, und die Zeilen werden von der letzten an genommen</translation>
    </message>
    <message>
        <source>the numbers in column '{}' begin at {:.9g} and are taken for days: no unit is given</source>
        <translation>die Zahlen in Spalte „{}“ beginnen bei {:.9g} und werden als Tage gelesen: Es ist keine Einheit angegeben</translation>
    </message>
    <message>
        <source>the time in column '{}' begins at {:.9g} and has no unit: it is taken in seconds, and may be in days</source>
        <translation>die Zeit in Spalte „{}“ beginnt bei {:.9g} und hat keine Einheit: Sie wird in Sekunden genommen, und es können Tage sein</translation>
    </message>
    <message>
        <source>this is an HDF5 file that MATLAB did not write</source>
        <translation>dies ist eine HDF5-Datei, die nicht MATLAB geschrieben hat</translation>
    </message>
    <message>
        <source>Export the recording as MDF, as a MATLAB file or as CSV.</source>
        <translation>Exportieren Sie die Messung als MDF, als MATLAB-Datei oder als CSV.</translation>
    </message>
    <message>
        <source>'{}' cannot be made of these arguments</source>
        <translation>„{}“ lässt sich aus diesen Argumenten nicht bilden</translation>
    </message>
    <message>
        <source>'{}' is a type of the language; nothing else may have this name</source>
        <translation>„{}“ ist ein Typ der Sprache; nichts anderes darf so heißen</translation>
    </message>
    <message>
        <source>give it another name</source>
        <translation>einen anderen Namen geben</translation>
    </message>
    <message>
        <source>'{}' cannot be a value of the enumeration {}: it is an attribute of all enumerations</source>
        <translation>„{}“ kann kein Wert der Aufzählung {} sein: es ist ein Attribut aller Aufzählungen</translation>
    </message>
    <message>
        <source>'{}' stands twice among the values of the enumeration {}</source>
        <translation>„{}“ steht zweimal unter den Werten der Aufzählung {}</translation>
    </message>
    <message>
        <source>a {} has no equations and no algorithms</source>
        <translation>{} hat keine Gleichungen und keine Algorithmen</translation>
    </message>
    <message>
        <source>write them in the model that holds it</source>
        <translation>sie in das Modell schreiben, das sie enthält</translation>
    </message>
    <message>
        <source>'{}' cannot be {} in a {}</source>
        <translation>„{}“ kann nicht {} sein in: {}</translation>
    </message>
    <message>
        <source>remove the prefix, or declare it in the model that holds it</source>
        <translation>den Vorsatz entfernen, oder im umgebenden Modell deklarieren</translation>
    </message>
    <message>
        <source>'{}' is an array or has a prefix: a class that extends it can hold nothing else</source>
        <translation>„{}“ ist ein Feld oder hat einen Vorsatz: eine Klasse, die davon erbt, kann nichts anderes enthalten</translation>
    </message>
    <message>
        <source>declare a component of it instead</source>
        <translation>stattdessen eine Komponente davon deklarieren</translation>
    </message>
    <message>
        <source>the base class '{}' is replaceable</source>
        <translation>die Basisklasse „{}“ ist ersetzbar (replaceable)</translation>
    </message>
    <message>
        <source>extend a class that cannot be replaced</source>
        <translation>von einer Klasse erben, die nicht ersetzt werden kann</translation>
    </message>
    <message>
        <source>two imports have the same name '{}'</source>
        <translation>zwei Importe haben denselben Namen „{}“</translation>
    </message>
    <message>
        <source>name one of them: import NAME = …</source>
        <translation>einen davon benennen: import NAME = …</translation>
    </message>
    <message>
        <source>'{}' is no package and no element of a package; it cannot be imported</source>
        <translation>„{}“ ist kein Paket und kein Element eines Pakets und kann nicht importiert werden</translation>
    </message>
    <message>
        <source>name it by its full name</source>
        <translation>den vollen Namen schreiben</translation>
    </message>
    <message>
        <source>'{}' of the function {} is neither input nor output nor protected</source>
        <translation>„{}“ der Funktion {} ist weder Eingang noch Ausgang noch geschützt</translation>
    </message>
    <message>
        <source>declare it below "protected"</source>
        <translation>unter „protected“ deklarieren</translation>
    </message>
    <message>
        <source>a function has one algorithm and no initial one</source>
        <translation>eine Funktion hat einen einzigen Algorithmus und keinen für den Anfang</translation>
    </message>
    <message>
        <source>write all statements in one algorithm</source>
        <translation>alle Anweisungen in einen Algorithmus schreiben</translation>
    </message>
    <message>
        <source>'{}' is an input of the function and cannot be assigned</source>
        <translation>„{}“ ist ein Eingang der Funktion, ihm lässt sich nichts zuweisen</translation>
    </message>
    <message>
        <source>use a protected variable</source>
        <translation>eine geschützte Variable verwenden</translation>
    </message>
    <message>
        <source>'break' stands outside of a loop</source>
        <translation>„break“ steht außerhalb einer Schleife</translation>
    </message>
    <message>
        <source>'return' stands outside of a function</source>
        <translation>„return“ steht außerhalb einer Funktion</translation>
    </message>
    <message>
        <source>'when' cannot stand within another 'when'</source>
        <translation>„when“ kann nicht in einem anderen „when“ stehen</translation>
    </message>
    <message>
        <source>join the conditions by 'and'</source>
        <translation>die Bedingungen mit „and“ verbinden</translation>
    </message>
    <message>
        <source>'{}' is no package: '{}' in it cannot be used from outside</source>
        <translation>„{}“ ist kein Paket: „{}“ darin lässt sich von außen nicht verwenden</translation>
    </message>
    <message>
        <source>declare it "encapsulated", or move it to a package</source>
        <translation>es „encapsulated“ deklarieren, oder in ein Paket verschieben</translation>
    </message>
    <message>
        <source>'{}' takes no function as its argument '{}'</source>
        <translation>„{}“ nimmt keine Funktion als Argument „{}“</translation>
    </message>
    <message>
        <source>'{}' has several outputs and cannot be called for each element of an array</source>
        <translation>„{}“ hat mehrere Ausgänge und lässt sich nicht für jedes Element eines Felds aufrufen</translation>
    </message>
    <message>
        <source>call it in a loop</source>
        <translation>in einer Schleife aufrufen</translation>
    </message>
    <message>
        <source>the arguments of '{}' differ in size</source>
        <translation>die Argumente von „{}“ sind verschieden groß</translation>
    </message>
    <message>
        <source>'{}' was redeclared before, and is not replaceable since</source>
        <translation>„{}“ wurde schon ersetzt und ist seitdem nicht mehr ersetzbar</translation>
    </message>
    <message>
        <source>write "redeclare replaceable" where it is redeclared first</source>
        <translation>bei der ersten Ersetzung „redeclare replaceable“ schreiben</translation>
    </message>
    <message>
        <source>the constant '{}' depends on the parameter '{}'</source>
        <translation>die Konstante „{}“ hängt vom Parameter „{}“ ab</translation>
    </message>
    <message>
        <source>declare it as parameter</source>
        <translation>als Parameter deklarieren</translation>
    </message>
    <message>
        <source>'{}' continues a class of its name, but none is inherited</source>
        <translation>„{}“ setzt eine Klasse dieses Namens fort, doch es wird keine geerbt</translation>
    </message>
    <message>
        <source>give the class a name of its own</source>
        <translation>der Klasse einen eigenen Namen geben</translation>
    </message>
    <message>
        <source>'{}' of '{}' is final and cannot be redeclared</source>
        <translation>„{}“ von „{}“ ist final und kann nicht ersetzt werden</translation>
    </message>
    <message>
        <source>'{}' is public where it is inherited from, and protected here</source>
        <translation>„{}“ ist öffentlich, wo es geerbt wird, und hier geschützt</translation>
    </message>
    <message>
        <source>'{}' is protected where it is inherited from, and public here</source>
        <translation>„{}“ ist geschützt, wo es geerbt wird, und hier öffentlich</translation>
    </message>
    <message>
        <source>redeclare it in a section of the same kind</source>
        <translation>in einem Abschnitt derselben Art ersetzen</translation>
    </message>
    <message>
        <source>'{}' is a constant and cannot be redeclared</source>
        <translation>„{}“ ist eine Konstante und kann nicht ersetzt werden</translation>
    </message>
    <message>
        <source>'{}' is final and cannot be redeclared</source>
        <translation>„{}“ ist final und kann nicht ersetzt werden</translation>
    </message>
    <message>
        <source>declare a component of another name</source>
        <translation>eine Komponente anderen Namens deklarieren</translation>
    </message>
    <message>
        <source>'time' can be used in models and blocks only</source>
        <translation>„time“ lässt sich nur in Modellen und Blöcken verwenden</translation>
    </message>
    <message>
        <source>give it as an argument, or set the variable in the model that holds it</source>
        <translation>als Argument übergeben, oder die Variable im umgebenden Modell setzen</translation>
    </message>
    <message>
        <source>a subscript of this dimension is a value of {}, not {}</source>
        <translation>ein Index dieser Dimension ist ein Wert von {}, nicht {}</translation>
    </message>
    <message>
        <source>'{}' is declared on a condition</source>
        <translation>„{}“ ist mit einer Bedingung deklariert</translation>
    </message>
    <message>
        <source>the text '{}' is used before it is set</source>
        <translation>der Text „{}“ wird verwendet, bevor er gesetzt ist</translation>
    </message>
    <message>
        <source>give it a value where it is declared</source>
        <translation>bei der Deklaration einen Wert geben</translation>
    </message>
    <message>
        <source>'{}' is no format of a number</source>
        <translation>„{}“ ist kein Zahlenformat</translation>
    </message>
    <message>
        <source>write for example "8.3f"</source>
        <translation>zum Beispiel schreiben: "8.3f"</translation>
    </message>
    <message>
        <source>'{}' is a flow and must be Real, not {}</source>
        <translation>„{}“ ist eine Flussgröße und muss Real sein, nicht {}</translation>
    </message>
    <message>
        <source>remove the prefix, or declare it as Real</source>
        <translation>den Vorsatz entfernen, oder als Real deklarieren</translation>
    </message>
    <message>
        <source>the outer component '{}' has the size {}, the inner one {}</source>
        <translation>die äußere Komponente „{}“ hat die Größe {}, die innere {}</translation>
    </message>
    <message>
        <source>declare both alike</source>
        <translation>beide gleich deklarieren</translation>
    </message>
    <message>
        <source>'{}' is an input or output, and so is '{}', which holds it</source>
        <translation>„{}“ ist Eingang oder Ausgang, und „{}“, das es enthält, ebenso</translation>
    </message>
    <message>
        <source>remove one of the two prefixes</source>
        <translation>einen der beiden Vorsätze entfernen</translation>
    </message>
    <message>
        <source>'{}' is a {} and cannot have the prefix of a variable</source>
        <translation>„{}“ ist {} und kann keinen Vorsatz einer Variablen haben</translation>
    </message>
    <message>
        <source>remove the prefix</source>
        <translation>den Vorsatz entfernen</translation>
    </message>
    <message>
        <source>the iterator '{}' stands for dimensions of different sizes</source>
        <translation>die Laufvariable „{}“ steht für Dimensionen verschiedener Größe</translation>
    </message>
    <message>
        <source>an equation of texts is: variable = text</source>
        <translation>eine Gleichung von Texten lautet: Variable = Text</translation>
    </message>
    <message>
        <source>the text '{}' is set twice</source>
        <translation>der Text „{}“ wird zweimal gesetzt</translation>
    </message>
    <message>
        <source>it has {} dimensions, not {}</source>
        <translation>es hat {} Dimensionen, nicht {}</translation>
    </message>
    <message>
        <source>the function '{}' is partial and cannot be called</source>
        <translation>die Funktion „{}“ ist partiell und kann nicht aufgerufen werden</translation>
    </message>
    <message>
        <source>call a function that extends it</source>
        <translation>eine Funktion aufrufen, die davon erbt</translation>
    </message>
    <message>
        <source>the condition after 'while' must be Boolean, not {}</source>
        <translation>die Bedingung nach „while“ muss Boolean sein, nicht {}</translation>
    </message>
    <message>
        <source>this cannot be written: {}</source>
        <translation>dies lässt sich nicht schreiben: {}</translation>
    </message>
    <message>
        <source>Check that the directory exists, may be written and has room.</source>
        <translation>Prüfen, ob das Verzeichnis existiert, beschreibbar ist und Platz hat.</translation>
    </message>
    <message>
        <source>this is a directory, not a file</source>
        <translation>dies ist ein Verzeichnis, keine Datei</translation>
    </message>
    <message>
        <source>this is a pipe or a device, not a file</source>
        <translation>dies ist eine Pipe oder ein Gerät, keine Datei</translation>
    </message>
    <message>
        <source>Copy what it gives into a file.</source>
        <translation>Was sie liefert, in eine Datei kopieren.</translation>
    </message>
    <message>
        <source>the file has more than {} MB</source>
        <translation>die Datei hat mehr als {} MB</translation>
    </message>
    <message>
        <source>another program is saving this study at the moment</source>
        <translation>ein anderes Programm speichert diese Studie gerade</translation>
    </message>
    <message>
        <source>Try again when it has finished.</source>
        <translation>Noch einmal versuchen, wenn es fertig ist.</translation>
    </message>
    <message>
        <source>a file has this name</source>
        <translation>eine Datei heißt so</translation>
    </message>
    <message>
        <source>a directory has this name</source>
        <translation>ein Verzeichnis heißt so</translation>
    </message>
    <message>
        <source>a link on its way leads to another directory</source>
        <translation>ein Link auf dem Weg führt in ein anderes Verzeichnis</translation>
    </message>
    <message>
        <source>this was changed since it was written; it is kept as &quot;{}&quot;</source>
        <translation>dies wurde geändert, seit es geschrieben wurde; es bleibt als „{}“ erhalten</translation>
    </message>
    <message>
        <source>this directory holds something else than results</source>
        <translation>dieses Verzeichnis enthält etwas anderes als Ergebnisse</translation>
    </message>
    <message>
        <source>Give a new or an empty directory, or one with earlier results.</source>
        <translation>Ein neues oder leeres Verzeichnis angeben, oder eines mit früheren Ergebnissen.</translation>
    </message>
    <message>
        <source>results need a directory, and this is none</source>
        <translation>Ergebnisse brauchen ein Verzeichnis, und dies ist keines</translation>
    </message>
    <message>
        <source>another run writes its results there</source>
        <translation>ein anderer Lauf schreibt seine Ergebnisse dorthin</translation>
    </message>
    <message>
        <source>Wait until it has ended, or give another directory.</source>
        <translation>Warten, bis er beendet ist, oder ein anderes Verzeichnis angeben.</translation>
    </message>
    <message>
        <source>the study itself lies among the results that would be replaced</source>
        <translation>die Studie selbst liegt unter den Ergebnissen, die ersetzt würden</translation>
    </message>
    <message>
        <source>Give another directory.</source>
        <translation>Ein anderes Verzeichnis angeben.</translation>
    </message>
    <message>
        <source>this is a file of the study itself</source>
        <translation>dies ist eine Datei der Studie selbst</translation>
    </message>
    <message>
        <source>the entry &quot;{}&quot; {}</source>
        <translation>der Eintrag „{}“ {}</translation>
    </message>
    <message>
        <source>Get the file again from where it came from.</source>
        <translation>Die Datei noch einmal von ihrer Quelle holen.</translation>
    </message>
    <message>
        <source>the archive unpacks to {} MB, more than {} MB</source>
        <translation>das Archiv ist entpackt {} MB groß, mehr als {} MB</translation>
    </message>
    <message>
        <source>this is no zip archive</source>
        <translation>dies ist kein Zip-Archiv</translation>
    </message>
    <message>
        <source>this archive holds no study.json</source>
        <translation>dieses Archiv enthält keine study.json</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>Do not trust this file, or unpack it with another tool and open its directory.</source>
        <translation>Dieser Datei nicht trauen, oder sie mit einem anderen Werkzeug entpacken und das Verzeichnis öffnen.</translation>
    </message>
    <message>
        <source>the archive holds {} files, more than {}</source>
        <translation>das Archiv enthält {} Dateien, mehr als {}</translation>
    </message>
    <message>
        <source>the entry &quot;{}&quot; unpacks to {} MB, more than {} MB</source>
        <translation>der Eintrag „{}“ ist entpackt {} MB groß, mehr als {} MB</translation>
    </message>
    <message>
        <source>the entry &quot;{}&quot; unpacks to {} times its size, more than {}</source>
        <translation>der Eintrag „{}“ ist entpackt das {}-Fache seiner Größe, mehr als das {}-Fache</translation>
    </message>
    <message>
        <source>the archive unpacks to {} times its size, more than {}</source>
        <translation>das Archiv ist entpackt das {}-Fache seiner Größe, mehr als das {}-Fache</translation>
    </message>
    <message>
        <source>experiment '{}': the file '{}' is not in the archive</source>
        <translation>Experiment „{}“: die Datei „{}“ liegt nicht im Archiv</translation>
    </message>
    <message>
        <source>An archive reads itself alone: put the measurement into it.</source>
        <translation>Ein Archiv liest nur sich selbst: die Messung hineinlegen.</translation>
    </message>
    <message>
        <source>the library '{}' is not in the archive</source>
        <translation>die Bibliothek „{}“ liegt nicht im Archiv</translation>
    </message>
    <message>
        <source>An archive reads itself alone: pack the directory of the study, which puts the library into it.</source>
        <translation>Ein Archiv liest nur sich selbst: das Verzeichnis der Studie packen, das legt die Bibliothek hinein.</translation>
    </message>
    <message>
        <source>the entry "{}" cannot be unpacked: {}</source>
        <translation>der Eintrag „{}“ lässt sich nicht entpacken: {}</translation>
    </message>
    <message>
        <source>Check that {} may be written and has room.</source>
        <translation>Prüfen, ob {} beschreibbar ist und Platz hat.</translation>
    </message>
    <message>
        <source>the entry "{}" lies below the entry "{}", which is a file</source>
        <translation>der Eintrag „{}“ liegt unter dem Eintrag „{}“, der eine Datei ist</translation>
    </message>
    <message>
        <source>the measurement is called "{}" in the study, which cannot name it as it is called</source>
        <translation>die Messung heißt in der Studie „{}“; ihren eigenen Namen kann eine Studie nicht nennen</translation>
    </message>
    <message>
        <source>{}: a text holds the character U+0000</source>
        <translation>{}: ein Text enthält das Zeichen U+0000</translation>
    </message>
    <message>
        <source>Take it out: no name and no path holds it.</source>
        <translation>Es herausnehmen: kein Name und kein Pfad enthält es.</translation>
    </message>
    <message>
        <source>this exists already and is no study</source>
        <translation>dies existiert schon und ist keine Studie</translation>
    </message>
    <message>
        <source>this exists already and is another study, or was saved since it was packed</source>
        <translation>dies existiert schon und ist eine andere Studie, oder es wurde seit dem Packen gespeichert</translation>
    </message>
    <message>
        <source>Give another name, or remove it first.</source>
        <translation>Einen anderen Namen angeben oder es vorher entfernen.</translation>
    </message>
    <message>
        <source>this exists already and is no FMU that was exported before</source>
        <translation>dies existiert schon und ist keine früher exportierte FMU</translation>
    </message>
    <message>
        <source>this exists already and holds no traces that were exported before</source>
        <translation>dies existiert schon und enthält keine früher exportierten Verläufe</translation>
    </message>
    <message>
        <source>the ending of this name says no format of parameters</source>
        <translation>die Endung dieses Namens sagt kein Format von Parametern</translation>
    </message>
    <message>
        <source>It is .csv, .json, .ssv (SSP 1.0), .dcm (DCM 2.0) or .cdfx (ASAM CDF 2.0).</source>
        <translation>Sie ist .csv, .json, .ssv (SSP 1.0), .dcm (DCM 2.0) oder .cdfx (ASAM CDF 2.0).</translation>
    </message>
    <message>
        <source>this exists already and is no MDF file of traces that was exported before</source>
        <translation>dies gibt es schon, und es ist keine MDF-Datei mit Verläufen, die früher ausgegeben wurde</translation>
    </message>
    <message>
        <source>this exists already and holds no parameters that were exported before</source>
        <translation>dies gibt es schon, und es enthält keine Parameter, die früher ausgegeben wurden</translation>
    </message>
    <message>
        <source>this exists already and is no model text that was exported before, or it was changed since</source>
        <translation>dies existiert schon und ist kein früher exportierter Modelltext, oder es wurde seitdem geändert</translation>
    </message>
    <message>
        <source>there is no library '{}'</source>
        <translation>es gibt keine Bibliothek „{}“</translation>
    </message>
    <message>
        <source>An archive reads itself alone, so the library must come along: put it there, or take it out of study.json.</source>
        <translation>Ein Archiv liest nur sich selbst, also muss die Bibliothek mit: sie dorthin legen oder aus study.json nehmen.</translation>
    </message>
    <message>
        <source>A study archive holds study.json, a model (.mo) and its measurements at its top.</source>
        <translation>Ein Studienarchiv enthält zuoberst study.json, ein Modell (.mo) und dessen Messungen.</translation>
    </message>
    <message>
        <source>this archive is of another kind: &quot;{}&quot;</source>
        <translation>dieses Archiv ist von anderer Art: „{}“</translation>
    </message>
    <message>
        <source>this exists already and is not empty</source>
        <translation>dies existiert schon und ist nicht leer</translation>
    </message>
    <message>
        <source>Name a new directory.</source>
        <translation>Ein neues Verzeichnis nennen.</translation>
    </message>
    <message>
        <source>this exists already</source>
        <translation>dies existiert schon</translation>
    </message>
    <message>
        <source>Give another name.</source>
        <translation>Einen anderen Namen nennen.</translation>
    </message>
    <message>
        <source>there is no place for temporary files: {}</source>
        <translation>es gibt keinen Platz für vorübergehende Dateien: {}</translation>
    </message>
    <message>
        <source>Set TMPDIR to a directory that may be written.</source>
        <translation>TMPDIR auf ein beschreibbares Verzeichnis setzen.</translation>
    </message>
    <message>
        <source>no temporary directory can be made: {}</source>
        <translation>ein vorübergehendes Verzeichnis lässt sich nicht anlegen: {}</translation>
    </message>
    <message>
        <source>Check that it may be written and has room, or set TMPDIR.</source>
        <translation>Prüfen, ob es beschreibbar ist und Platz hat, oder TMPDIR setzen.</translation>
    </message>
    <message>
        <source>{} and {}</source>
        <translation>{} und {}</translation>
    </message>
    <message>
        <source>the fitted recordings hold {} near {:.4g}, '{}' has it between {:.4g} and {:.4g}: what the model says of that is extrapolated</source>
        <translation>Die angepassten Aufzeichnungen halten {} bei {}, „{}“ hat dort {} bis {}: Was das Modell dazu sagt, ist extrapoliert</translation>
    </message>
    <message>
        <source>'{}' begins with {} at {:.4g}{} where the model begins at {:.4g}{}</source>
        <translation>„{}“ beginnt bei {} mit {}{}, das Modell mit {}{}</translation>
    </message>
    <message>
        <source>{}: tell its start value, or fit it (&quot;initial&quot;)</source>
        <translation>{}: den Startwert angeben oder anpassen („initial“)</translation>
    </message>
    <message>
        <source>{}, though a start value is fitted there: another one may be wrong, that of a part which an effect has added, too</source>
        <translation>{}, obwohl dort ein Startwert angepasst wird: Ein anderer kann falsch sein, auch der eines Teils, den ein Effekt hinzugefügt hat</translation>
    </message>
    <message>
        <source>output '{}' of '{}' reads {:.5g} from {:.4g} s to {:.4g} s without any change, and hardly ever twice the same elsewhere: did the sensor or the logger stick?</source>
        <translation>Ausgang „{}“ von „{}“ zeigt {} von {} s bis {} s ohne jede Änderung und sonst kaum je zweimal dasselbe: Hing der Sensor oder die Aufzeichnung?</translation>
    </message>
    <message>
        <source>output '{}' of '{}' reads {:.5g} from {:.4g} s to {:.4g} s without any change, and never goes beyond: does the range of the sensor or the logger end there?</source>
        <translation>Ausgang „{}“ von „{}“ zeigt {} von {} s bis {} s ohne jede Änderung und geht nie darüber hinaus: Endet dort der Bereich des Sensors oder der Aufzeichnung?</translation>
    </message>
    <message>
        <source>what is left on output '{}' of '{}' is not quite noise, but far less than what was found explains: the forms of its blocks (a rounded change of sign, an exact square) may leave as much</source>
        <translation>Was an Ausgang „{}“ von „{}“ bleibt, ist nicht ganz Rauschen, aber viel weniger, als das Gefundene erklärt: So viel können die Formen seiner Blöcke lassen (ein gerundeter Vorzeichenwechsel, ein genaues Quadrat)</translation>
    </message>
    <message>
        <source>the input '{}' is held between its samples by what the outputs say, and the study joins them by straight lines: held, a fit leaves an error of {:.2f} %, on straight lines one of {:.2f} %</source>
        <translation>Der Eingang „{}“ wird nach dem, was die Ausgänge sagen, zwischen seinen Abtastwerten gehalten, und die Studie verbindet sie durch Geraden: Gehalten lässt eine Anpassung einen Fehler von {:.2f} %, auf Geraden einen von {:.2f} %</translation>
    </message>
    <message>
        <source>the input '{}' is held between its samples by what the outputs say, or reaches the component half a sample late, which looks nearly the same, and the study joins them by straight lines: held, a fit leaves an error of {:.2f} %, on straight lines one of {:.2f} %</source>
        <translation>Der Eingang „{}“ wird nach dem, was die Ausgänge sagen, zwischen seinen Abtastwerten gehalten, oder er erreicht das Bauteil einen halben Abtastwert später, was fast gleich aussieht; die Studie verbindet sie durch Geraden: Gehalten lässt eine Anpassung einen Fehler von {:.2f} %, auf Geraden einen von {:.2f} %</translation>
    </message>
    <message>
        <source>write &quot;{}&quot;: {} under &quot;inputs&quot; of the study (in the window: the menu of the input among the measurements)</source>
        <translation>in der Studie unter &quot;inputs&quot; schreiben: &quot;{}&quot;: {} (im Fenster: das Menü des Eingangs bei den Messungen)</translation>
    </message>
    <message>
        <source>{}; all that is told here is with it held: {}</source>
        <translation>{}; alles hier Gesagte gilt mit gehaltenem Eingang: {}</translation>
    </message>
    <message>
        <source>{}; {}</source>
        <translation>{}; {}</translation>
    </message>
    <message>
        <source>the model needs the slope of the input {}, which is held between its samples</source>
        <translation>Das Modell braucht die Steigung des Eingangs {}, der zwischen seinen Abtastwerten gehalten wird</translation>
    </message>
    <message>
        <source>what jumps has no slope: give it &quot;interpolation&quot;: &quot;linear&quot;, or let the model filter it</source>
        <translation>Was springt, hat keine Steigung: „interpolation“ auf „linear“ setzen, oder das Modell filtern lassen</translation>
    </message>
    <message>
        <source>the input '{}' is stamped {:.3g} s late ({:.2g} samples; a mean over the last sample is late by half of one): the search reckons with it, the errors that are reported do not; set it in the study as its &quot;clock&quot;: {:.3g}</source>
        <translation>Der Eingang „{}“ trägt seinen Zeitstempel {:.3g} s zu spät ({:.2g} Abtastwerte; ein Mittel über den letzten Abtastwert kommt um einen halben zu spät): Die Suche berücksichtigt das, die genannten Fehler nicht; in der Studie als &quot;clock&quot;: {:.3g} eintragen</translation>
    </message>
    <message>
        <source>with its inputs on time the model has an error of {:.2f} %, and of {:.2f} % on recordings that were not fitted</source>
        <translation>Mit rechtzeitigen Eingängen hat das Modell einen Fehler von {:.2f} % und von {:.2f} % auf nicht angepassten Aufzeichnungen</translation>
    </message>
    <message>
        <source>with its inputs on time the model has an error of {:.2f} %</source>
        <translation>Mit rechtzeitigen Eingängen hat das Modell einen Fehler von {:.2f} %</translation>
    </message>
    <message>
        <source>the inputs jump just before the next sample ({} jumps): they are held in between and do not run straight from sample to sample, or reach the component half a sample late, which looks nearly the same; the parameters reckon with it, the errors that are reported do not</source>
        <translation>Die Eingänge springen kurz vor dem nächsten Abtastwert ({} Sprünge): Sie werden dazwischen gehalten und verlaufen nicht gerade von Wert zu Wert, oder sie erreichen die Komponente einen halben Abtastschritt zu spät, was fast gleich aussieht; die Parameter berücksichtigen das, die genannten Fehler nicht</translation>
    </message>
    <message>
        <source>the inputs jump between two samples ({} jumps), and the outputs tell when: the parameters reckon with it, the errors that are reported are with straight lines from sample to sample; record faster, or log the moment of each jump</source>
        <translation>Die Eingänge springen zwischen zwei Abtastwerten ({} Sprünge), und die Ausgänge sagen, wann: Die Parameter berücksichtigen das, die genannten Fehler gelten für gerade Linien von Wert zu Wert; schneller aufzeichnen oder den Zeitpunkt jedes Sprungs festhalten</translation>
    </message>
    <message>
        <source>'{}' leaves the range of the fitted recordings on {} by {:.0f} % of that range: what the model says there is extrapolated</source>
        <translation>„{}“ verlässt bei {} den Bereich der angepassten Aufzeichnungen um {} % dieses Bereichs: Was das Modell dort sagt, ist extrapoliert</translation>
    </message>
    <message>
        <source>input {}</source>
        <translation>Eingang {}</translation>
    </message>
    <message>
        <source>output {}</source>
        <translation>Ausgang {}</translation>
    </message>
    <message>
        <source>{} seems to be another one in '{}' (about {:.4g}) than in the other recordings (about {:.4g}): was the component, or its condition, the same?</source>
        <translation>{} scheint in „{}“ ein anderer Wert zu sein (etwa {}) als in den übrigen Aufzeichnungen (etwa {}): War das Bauteil dasselbe, und in demselben Zustand?</translation>
    </message>
    <message>
        <source>nothing can be judged: no measured output moves in the fitted recordings ({}), and what stands still tells neither parameters nor effects</source>
        <translation>ein Urteil ist nicht möglich: Kein gemessener Ausgang bewegt sich in den angepassten Aufzeichnungen ({}), und was stillsteht, verrät weder Parameter noch Effekte</translation>
    </message>
    <message>
        <source>too few samples to judge: {} samples, {} parameters; structure is told from noise where an output has {} samples and there are as many beyond the parameters</source>
        <translation>zu wenige Messwerte für ein Urteil: {} Messwerte, {} Parameter; Struktur ist von Rauschen zu unterscheiden, wo ein Ausgang {} Messwerte hat und es ebenso viele über die Parameter hinaus gibt</translation>
    </message>
    <message>
        <source>{} rests at a bound ({:.4g}{}{}): the bound is too narrow, or the model lacks something that the parameter stands in for</source>
        <translation>{} liegt an einer Grenze ({}{}{}): Die Grenze ist zu eng, oder dem Modell fehlt etwas, für das der Parameter einsteht</translation>
    </message>
    <message>
        <source>long recordings, in which means of neighbouring samples would blur what is fast: the search works on their first part, the fit before and after it on all of them</source>
        <translation>lange Aufzeichnungen, in denen Mittel über benachbarte Abtastwerte verwischen würden, was schnell ist: Die Suche arbeitet mit ihrem ersten Teil, die Anpassung davor und danach mit allen Abtastwerten</translation>
    </message>
    <message>
        <source>{} (on means of {} samples)</source>
        <translation>{} (mit Mitteln über {} Abtastwerte)</translation>
    </message>
    <message>
        <source>long recordings: the search works on means of {} samples, the fit before and after it on all of them</source>
        <translation>lange Aufzeichnungen: Die Suche arbeitet mit Mitteln über {} Abtastwerte, die Anpassung davor und danach mit allen</translation>
    </message>
    <message>
        <source>the search was ended after {:.0f} times the work of the fit of the model as given, and says what it had until then; with more patience (--patience {:.0f}) it goes on</source>
        <translation>die Suche wurde nach dem {}-fachen der Arbeit für die Anpassung des gegebenen Modells beendet und sagt, was sie bis dahin hatte; mit mehr Geduld (--patience {}) geht sie weiter</translation>
    </message>
    <message>
        <source>{} stands at {} and {} with one set of parameters: equal sensors, and the data do not tell them apart</source>
        <translation>{} steht an {} und {} mit einem gemeinsamen Satz Parameter: Die Sensoren sind gleich, und die Daten unterscheiden sie nicht</translation>
    </message>
    <message>
        <source>{} stands at {} and {} with one set of parameters: they feed equal blocks, and the data do not tell them apart</source>
        <translation>{} steht an {} und {} mit einem gemeinsamen Satz Parameter: Dahinter liegen gleiche Blöcke, und die Daten unterscheiden sie nicht</translation>
    </message>
    <message>
        <source>the condition seems to have changed in mid run: {} at about {:.4g} s</source>
        <translation>der Zustand scheint sich während des Laufs geändert zu haben: {} bei etwa {} s</translation>
    </message>
    <message>
        <source>on '{}', which was not fitted, the error is {:.3g} % with the value of {} before that change, {:.3g} % with the one after it, and {:.3g} % with the change at the same time</source>
        <translation>auf '{}', das nicht angepasst wurde, beträgt der Fehler {} % mit dem Wert von {} vor dieser Änderung, {} % mit dem danach und {} % mit der Änderung zur gleichen Zeit</translation>
    </message>
    <message>
        <source>nothing there has a motion of its own</source>
        <translation>Dort hat nichts eine eigene Bewegung</translation>
    </message>
    <message>
        <source>it came to a far poorer optimum</source>
        <translation>sie kam zu einem weit schlechteren Optimum</translation>
    </message>
    <message>
        <source>the last fit failed, the search's own stands: {}</source>
        <translation>Die letzte Anpassung schlug fehl, es gilt die der Suche: {}</translation>
    </message>
    <message>
        <source>the model switches faster than its steps: slopes are taken from changes of the parameters, and the fit is slow; widen what rounds the change off (&quot;i_eps&quot;, &quot;w_eps&quot;) if you can</source>
        <translation>das Modell schaltet schneller als seine Schritte: Steigungen werden aus Änderungen der Parameter bestimmt, und die Schätzung ist langsam; was den Wechsel rundet („i_eps“, „w_eps“), nach Möglichkeit verbreitern</translation>
    </message>
    <message>
        <source>from the start values of the study the fit ends at a poorer optimum: the search begins at the best of {} starts about them</source>
        <translation>von den Startwerten der Studie aus endet die Anpassung in einem schlechteren Optimum: die Suche beginnt beim besten von {} Starts um sie herum</translation>
    </message>
    <message>
        <source>there is no block library at {}</source>
        <translation>bei {} ist keine Blockbibliothek</translation>
    </message>
    <message>
        <source>let ANALOGON_LIBRARY name the folder that holds Analogon/package.mo, or leave it unset</source>
        <translation>ANALOGON_LIBRARY muss den Ordner nennen, in dem Analogon/package.mo liegt, oder fehlen</translation>
    </message>
    <message>
        <source>{} seems to move with the recorded channel {}</source>
        <translation>{} scheint dem aufgezeichneten Kanal {} zu folgen</translation>
    </message>
    <message>
        <source>experiment '{}': {}</source>
        <translation>Versuch „{}“: {}</translation>
    </message>
    <message>
        <source>experiment '{}': a relation of {} switches without end at t = {:.6g} s; what follows there is only as good as the steps of the fit</source>
        <translation>Versuch „{}“: Eine Relation von {} schaltet bei t = {} s ohne Ende; was dort folgt, ist nur so gut wie die Schritte der Anpassung</translation>
    </message>
    <message>
        <source>a step from {} to {} and, after half the time, back</source>
        <translation>Sprung von {} auf {} und nach der halben Zeit zurück</translation>
    </message>
    <message>
        <source>a slow ramp from {} to {} and back</source>
        <translation>langsame Rampe von {} auf {} und zurück</translation>
    </message>
    <message>
        <source>stairs from {} to {} and back in eight steps each way</source>
        <translation>Treppe von {} auf {} und zurück in je acht Stufen</translation>
    </message>
    <message>
        <source>small steps of a tenth about {}</source>
        <translation>kleine Sprünge von einem Zehntel um {}</translation>
    </message>
    <message>
        <source>a fast change between {} and {}, some forty times</source>
        <translation>schneller Wechsel zwischen {} und {}, etwa vierzigmal</translation>
    </message>
    <message>
        <source>a sine sweep between {} and {}, from one to sixty periods a recording</source>
        <translation>Sinusdurchlauf zwischen {} und {}, von einer bis sechzig Perioden je Aufzeichnung</translation>
    </message>
    <message>
        <source>{} held from the start</source>
        <translation>konstant {} von Anfang an</translation>
    </message>
    <message>
        <source>input {} as {}, over {:.3g} s</source>
        <translation>Eingang {} als {}, über {} s</translation>
    </message>
    <message>
        <source>the study has no experiment with the role &quot;fit&quot;</source>
        <translation>die Studie hat keinen Versuch mit der Rolle &quot;fit&quot;</translation>
    </message>
    <message>
        <source>there is no kind of effect '{}'</source>
        <translation>es gibt keine Art von Effekt „{}“</translation>
    </message>
    <message>
        <source>give at least one experiment that role</source>
        <translation>mindestens einem Versuch diese Rolle geben</translation>
    </message>
    <message>
        <source>give other start values, or narrower bounds</source>
        <translation>andere Startwerte oder engere Grenzen angeben</translation>
    </message>
    <message>
        <source>the data do not show this effect</source>
        <translation>die Daten zeigen diesen Effekt nicht</translation>
    </message>
    <message>
        <source>the recording does not show what tells this effect apart: {} &gt; 0</source>
        <translation>die Aufzeichnung zeigt nicht, woran man diesen Effekt erkennt: {} &gt; 0</translation>
    </message>
    <message>
        <source>unknown fault</source>
        <translation>unbekannter Fehler</translation>
    </message>
    <message>
        <source>{} with {}</source>
        <translation>{} mit {}</translation>
    </message>
    <message>
        <source>{} at {} from {} at {}</source>
        <translation>{} bei {} von {} bei {}</translation>
    </message>
    <message>
        <source>no programme of the inputs within their range tells {} with these sensors (at most {:.1f} standard deviations): another quantity has to be measured</source>
        <translation>kein Verlauf der Eingänge in ihrem Bereich unterscheidet mit diesen Sensoren {} (höchstens {} Standardabweichungen): Eine weitere Größe muss gemessen werden</translation>
    </message>
    <message>
        <source>{}, the other inputs at their means, would tell {} by more than {:.0f} standard deviations</source>
        <translation>{}, die übrigen Eingänge im Mittel, würde {} um mehr als {} Standardabweichungen unterscheiden</translation>
    </message>
    <message>
        <source>{}, the other inputs at their means, would tell {} by {:.0f} standard deviations</source>
        <translation>{}, die übrigen Eingänge im Mittel, würde {} um {} Standardabweichungen unterscheiden</translation>
    </message>
    <message>
        <source>converged after {} simulations</source>
        <translation>konvergiert nach {} Simulationen</translation>
    </message>
    <message>
        <source>stopped at the limit of {} simulations</source>
        <translation>an der Grenze von {} Simulationen beendet</translation>
    </message>
    <message>
        <source>cancelled; the best parameters so far are kept</source>
        <translation>abgebrochen; die bisher besten Parameter bleiben</translation>
    </message>
    <message>
        <source>the search could not be started</source>
        <translation>die Suche ließ sich nicht beginnen</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>stopped on a plain: at {:.6g}, {} has no influence any more; start elsewhere, or bound it</source>
        <translation>auf einer Ebene stehen geblieben: Bei {} hat {} keinen Einfluss mehr; anders beginnen oder Grenzen setzen</translation>
    </message>
    <message>
        <source>it began at the optimum</source>
        <translation>sie begann am Optimum</translation>
    </message>
    <message>
        <source>converged after one iteration</source>
        <translation>nach einem Schritt konvergiert</translation>
    </message>
    <message>
        <source>converged after {} iterations</source>
        <translation>konvergiert nach {} Iterationen</translation>
    </message>
    <message>
        <source>{} of '{}'</source>
        <translation>{} von „{}“</translation>
    </message>
    <message>
        <source>{} = {:.6g} lies {:.1f} standard deviations from its prior {:.6g} ± {:.3g}: the data contradict what was known</source>
        <translation>{} = {} liegt {} Standardabweichungen vom Vorwissen {} ± {}: Die Daten widersprechen dem, was bekannt war</translation>
    </message>
    <message>
        <source>{} is known from its prior alone: the data add nothing</source>
        <translation>{} ist nur durch das Vorwissen bekannt: Die Daten tragen nichts bei</translation>
    </message>
    <message>
        <source>{} rests at its lower bound {:.6g}</source>
        <translation>{} liegt an der unteren Grenze {}</translation>
    </message>
    <message>
        <source>{} rests at its upper bound {:.6g}</source>
        <translation>{} liegt an der oberen Grenze {}</translation>
    </message>
    <message>
        <source>{} of {} simulations failed and were passed over</source>
        <translation>{} von {} Simulationen sind gescheitert und wurden übergangen</translation>
    </message>
    <message>
        <source>experiment '{}': the integration is only accurate to {:.2g} % of the output's range</source>
        <translation>Versuch „{}“: Die Integration ist nur auf {} % des Bereichs des Ausgangs genau</translation>
    </message>
    <message>
        <source>no parameter is free</source>
        <translation>kein Parameter ist frei</translation>
    </message>
    <message>
        <source>all parameters rest at their bounds</source>
        <translation>alle Parameter liegen an ihren Grenzen</translation>
    </message>
    <message>
        <source>stopped at the limit of {} iterations while the cost still fell</source>
        <translation>an der Grenze von {} Iterationen beendet, während der Fehler noch fiel</translation>
    </message>
    <message>
        <source>converged</source>
        <translation>konvergiert</translation>
    </message>
    <message>
        <source>no step lowers the cost</source>
        <translation>kein Schritt senkt den Fehler</translation>
    </message>
    <message>
        <source>stopped after {} iterations in a flat valley: the cost hardly falls any more, and the parameters still move</source>
        <translation>nach {} Iterationen in einem flachen Tal beendet: Der Fehler fällt kaum noch, und die Parameter wandern weiter</translation>
    </message>
    <message>
        <source>experiment '{}' failed at t = {:.6g} s: {}</source>
        <translation>Versuch „{}“ ist bei t = {} s gescheitert: {}</translation>
    </message>
    <message>
        <source>experiment '{}' failed at t = {:.6g} s: {} ({})</source>
        <translation>Versuch „{}“ ist bei t = {} s gescheitert: {} ({})</translation>
    </message>
    <message>
        <source>looking for start values: {} of {}</source>
        <translation>Startwerte werden gesucht: {} von {}</translation>
    </message>
    <message>
        <source>{}; nor can it be simulated at any of {} other starts within the bounds</source>
        <translation>{}; auch von keinem von {} anderen Startwerten innerhalb der Grenzen lässt es sich simulieren</translation>
    </message>
    <message>
        <source>the model cannot be simulated at its start values ({}); the fit began elsewhere within the bounds, at {}</source>
        <translation>das Modell lässt sich bei seinen Startwerten nicht simulieren ({}); die Anpassung begann anderswo innerhalb der Grenzen, bei {}</translation>
    </message>
    <message>
        <source>{} = {:.4g}</source>
        <translation>{} = {}</translation>
    </message>
    <message>
        <source>{} is the root of {:.4g}</source>
        <translation>{} ist die Wurzel aus {}</translation>
    </message>
    <message>
        <source>{} is the logarithm of {:.4g}</source>
        <translation>{} ist der Logarithmus von {}</translation>
    </message>
    <message>
        <source>{} is the arcsine of {:.4g}</source>
        <translation>{} ist der Arkussinus von {}</translation>
    </message>
    <message>
        <source>{} is the arccosine of {:.4g}</source>
        <translation>{} ist der Arkuskosinus von {}</translation>
    </message>
    <message>
        <source>{} divides {:.4g} by 0</source>
        <translation>{} teilt {} durch 0</translation>
    </message>
    <message>
        <source>{} is the power of {:.4g} to {:.4g}</source>
        <translation>{} ist die Potenz von {} hoch {}</translation>
    </message>
    <message>
        <source>{} is beyond all numbers</source>
        <translation>{} ist jenseits aller Zahlen</translation>
    </message>
    <message>
        <source>{}, in the equation {}</source>
        <translation>{}, in der Gleichung {}</translation>
    </message>
    <message>
        <source>{} ({}), in the equation {}</source>
        <translation>{} ({}), in der Gleichung {}</translation>
    </message>
    <message>
        <source>{} ({}, line {})</source>
        <translation>{} ({}, Zeile {})</translation>
    </message>
    <message>
        <source>experiment '{}': {} stands still at {:.5g}{}: its error is told in percent of that</source>
        <translation>Versuch „{}“: {} steht still bei {}{}: Der Fehler wird in Prozent davon angegeben</translation>
    </message>
    <message>
        <source>experiment '{}': {} is 0 throughout: it has no error in percent, the root mean square deviation is {:.3g}{}</source>
        <translation>Versuch „{}“: {} ist durchweg 0: Es gibt keinen Fehler in Prozent, die mittlere quadratische Abweichung ist {}{}</translation>
    </message>
    <message>
        <source>experiment '{}': an output is not finite</source>
        <translation>Versuch „{}“: Ein Ausgang ist nicht endlich</translation>
    </message>
    <message>
        <source>the sensitivities are not finite</source>
        <translation>die Empfindlichkeiten sind nicht endlich</translation>
    </message>
    <message>
        <source>experiment '{}': the sensitivities are not finite</source>
        <translation>Versuch „{}“: Die Empfindlichkeiten sind nicht endlich</translation>
    </message>
    <message>
        <source>{} has no influence on what was measured here: fix it</source>
        <translation>{} hat keinen Einfluss auf das, was hier gemessen wurde: den Wert festhalten</translation>
    </message>
    <message>
        <source>{} cannot be told apart from these data: fix one</source>
        <translation>{} lassen sich mit diesen Daten nicht unterscheiden: einen festhalten</translation>
    </message>
    <message>
        <source>of these only {} is known: {}</source>
        <translation>davon ist nur {} bekannt: {}</translation>
    </message>
    <message>
        <source>{} is known far better than either: {}</source>
        <translation>{} ist weit besser bekannt als jedes für sich: {}</translation>
    </message>
    <message>
        <source>{} is not determined by these data: fix it</source>
        <translation>{} ist durch diese Daten nicht bestimmt: den Wert festhalten</translation>
    </message>
    <message>
        <source>{} and {} can hardly be told apart (correlation {:.5f})</source>
        <translation>{} und {} lassen sich kaum unterscheiden (Korrelation {})</translation>
    </message>
    <message>
        <source>The columns are {}.</source>
        <translation>Die Spalten sind {}.</translation>
    </message>
    <message>
        <source>Did you mean '{}'? The columns are {}.</source>
        <translation>Ist „{}“ gemeint? Die Spalten sind {}.</translation>
    </message>
    <message>
        <source>there is no column '{}'</source>
        <translation>es gibt keine Spalte „{}“</translation>
    </message>
    <message>
        <source>no number</source>
        <translation>keine Zahl</translation>
    </message>
    <message>
        <source>an infinite value</source>
        <translation>einen unendlichen Wert</translation>
    </message>
    <message>
        <source>column '{}' has {} here (data row {}; {} cells in all, the last in line {})</source>
        <translation>Spalte „{}“ hat hier {} (Datenzeile {}; {} Zellen insgesamt, die letzte in Zeile {})</translation>
    </message>
    <message>
        <source>column '{}' has {} here (data row {})</source>
        <translation>Spalte „{}“ hat hier {} (Datenzeile {})</translation>
    </message>
    <message>
        <source>Remove these rows, fill the cells, or leave them out with &quot;range&quot;: [from, to] in the study.</source>
        <translation>Diese Zeilen entfernen, die Zellen füllen, oder sie in der Studie mit &quot;range&quot;: [von, bis] auslassen.</translation>
    </message>
    <message>
        <source>the unit '{}' of column '{}' is not known</source>
        <translation>die Einheit „{}“ der Spalte „{}“ ist nicht bekannt</translation>
    </message>
    <message>
        <source>Give the unit that its numbers are in, in the header or in the study as {{&quot;column&quot;: &quot;{}&quot;, &quot;unit&quot;: …}}.</source>
        <translation>Die Einheit, in der ihre Zahlen stehen, in der Kopfzeile angeben oder in der Studie als {{&quot;column&quot;: &quot;{}&quot;, &quot;unit&quot;: …}}.</translation>
    </message>
    <message>
        <source>'({})' behind the name of column '{}' is no unit that is known: its numbers are taken to be in '{}', as the model wants them</source>
        <translation>„({})“ hinter dem Namen der Spalte „{}“ ist keine bekannte Einheit: ihre Zahlen gelten als in „{}“, wie das Modell sie verlangt</translation>
    </message>
    <message>
        <source>Where they are in another unit, give it in the study as {{&quot;column&quot;: &quot;{}&quot;, &quot;unit&quot;: …}}.</source>
        <translation>Stehen sie in einer anderen Einheit, diese in der Studie als {{&quot;column&quot;: &quot;{}&quot;, &quot;unit&quot;: …}} angeben.</translation>
    </message>
    <message>
        <source>column '{}' is in '{}', which cannot be converted to the '{}' of the model</source>
        <translation>Spalte „{}“ ist in „{}“, was sich nicht in „{}“ des Modells umrechnen lässt</translation>
    </message>
    <message>
        <source>Map another column, or give the unit in the study as {{&quot;column&quot;: &quot;{}&quot;, &quot;unit&quot;: …}}.</source>
        <translation>Eine andere Spalte zuordnen, oder die Einheit in der Studie angeben als {{&quot;column&quot;: &quot;{}&quot;, &quot;unit&quot;: …}}.</translation>
    </message>
    <message>
        <source>the recording pauses for {:.4g} s before this row; its usual step is {:.4g} s</source>
        <translation>die Aufzeichnung setzt vor dieser Zeile {} s lang aus; ihr üblicher Schritt ist {} s</translation>
    </message>
    <message>
        <source> ({} such gaps in all)</source>
        <translation> ({} solche Lücken insgesamt)</translation>
    </message>
    <message>
        <source>Between rows, inputs run linearly in '{}'. Use &quot;range&quot; in the study to leave a part out.</source>
        <translation>Zwischen den Zeilen verlaufen Eingänge linear in „{}“. Mit &quot;range&quot; in der Studie lässt sich ein Teil auslassen.</translation>
    </message>
    <message>
        <source>the recording has only one row</source>
        <translation>die Aufzeichnung hat nur eine Zeile</translation>
    </message>
    <message>
        <source>At least two samples are needed.</source>
        <translation>Mindestens zwei Abtastwerte sind nötig.</translation>
    </message>
    <message>
        <source>the time in column '{}' repeats in {} of {} rows: {}</source>
        <translation>die Zeit in Spalte „{}“ wiederholt sich in {} von {} Zeilen: {}</translation>
    </message>
    <message>
        <source>the time in column '{}' goes back in {} of {} rows: {}</source>
        <translation>die Zeit in Spalte „{}“ läuft in {} von {} Zeilen zurück: {}</translation>
    </message>
    <message>
        <source>{} after {} (line {})</source>
        <translation>{} nach {} (Zeile {})</translation>
    </message>
    <message>
        <source>These rows are copies of those before them: the logger wrote them twice; keep one of each.</source>
        <translation>Diese Zeilen sind Abschriften derer vor ihnen: Der Logger hat sie doppelt geschrieben; je eine behalten.</translation>
    </message>
    <message>
        <source>'{}' counts on there, so no row was written twice; it counts rows and is no time. </source>
        <translation>„{}“ zählt dort weiter, also wurde keine Zeile doppelt geschrieben; die Spalte zählt Zeilen und ist keine Zeit. </translation>
    </message>
    <message>
        <source>If a quantity jumps there (two rows for one moment), write the second a little later, by {:.2g} s. If the time has too few digits, export it with more; stamps of equal steps can be written anew. If a row was written twice, keep the right one.</source>
        <translation>Wenn dort eine Größe springt (zwei Zeilen für einen Augenblick), die zweite ein wenig später schreiben, um {:.2g} s. Wenn die Zeit zu wenige Stellen hat, sie mit mehr Stellen exportieren; Stempel gleicher Schritte lassen sich neu schreiben. Wenn eine Zeile doppelt geschrieben wurde, die richtige behalten.</translation>
    </message>
    <message>
        <source>By less than three samples: stamps of two loggers may be mixed, or written late. Correct the stamps of these rows; sorting them would mix what was measured at different moments.</source>
        <translation>Um weniger als drei Abtastungen: Stempel zweier Logger können gemischt oder zu spät geschrieben sein. Die Stempel dieser Zeilen berichtigen; Sortieren würde mischen, was zu verschiedenen Zeiten gemessen wurde.</translation>
    </message>
    <message>
        <source>The recording may have been started anew there: split the file before line {}, or use its first part alone (&quot;range&quot;: [{:.6g}, {:.6g}]). If the clock was set back, add {:.4g} s from there on. Sorting the rows would mix two recordings.</source>
        <translation>Dort kann die Aufzeichnung neu begonnen haben: die Datei vor Zeile {} teilen oder nur ihren ersten Teil verwenden („range“: [{:.6g}, {:.6g}]). Wenn die Uhr zurückgestellt wurde, ab dort {:.4g} s hinzuzählen. Sortieren würde zwei Aufzeichnungen mischen.</translation>
    </message>
    <message>
        <source>in line {}</source>
        <translation>in Zeile {}</translation>
    </message>
    <message>
        <source>in lines {}</source>
        <translation>in den Zeilen {}</translation>
    </message>
    <message>
        <source>in {} rows, first in lines {}</source>
        <translation>in {} Zeilen, zuerst in {}</translation>
    </message>
    <message>
        <source>column '{}' is below absolute zero {}: {:.6g} {}</source>
        <translation>Spalte „{}“ liegt {} unter dem absoluten Nullpunkt: {:.6g} {}</translation>
    </message>
    <message>
        <source>Is the unit right, or does the value stand for a sensor that failed? It is used as it stands.</source>
        <translation>Stimmt die Einheit, oder steht der Wert für einen ausgefallenen Sensor? Er wird verwendet, wie er dasteht.</translation>
    </message>
    <message>
        <source>the angle in column '{}' starts anew after each turn, {}</source>
        <translation>der Winkel in Spalte „{}“ beginnt nach jeder Umdrehung von vorn, {}</translation>
    </message>
    <message>
        <source>The angle of a model runs on: add a turn from each of these rows on, or map the speed instead.</source>
        <translation>Der Winkel eines Modells läuft weiter: ab jeder dieser Zeilen eine Umdrehung hinzuzählen oder die Drehzahl zuordnen.</translation>
    </message>
    <message>
        <source>column '{}' stands at {:.6g} from line {} to line {} while '{}' moves; elsewhere it reads the same in no more than {} rows on end</source>
        <translation>Spalte „{0}“ steht von Zeile {2} bis Zeile {3} bei {1:.6g}, während „{4}“ sich bewegt; sonst zeigt sie in höchstens {5} Zeilen nacheinander dasselbe</translation>
    </message>
    <message>
        <source>Did the sensor or the logger stick? It is used as it stands; leave the part out with &quot;range&quot;, or empty the cells of an output.</source>
        <translation>Hing der Sensor oder der Logger? Verwendet wird, was dasteht; den Teil mit „range“ weglassen oder die Zellen einer Ausgangsgröße leeren.</translation>
    </message>
    <message>
        <source>column '{}' holds {:.4g} {}, far beyond the {:.4g} … {:.4g} of nearly all its rows</source>
        <translation>Spalte „{}“ hat {:.4g} {}, weit außerhalb der {:.4g} … {:.4g} fast aller Zeilen</translation>
    </message>
    <message>
        <source>A value like this outweighs all others in a fit: empty the cell of an output, or correct it.</source>
        <translation>Ein solcher Wert überwiegt in einer Anpassung alle anderen: die Zelle einer Ausgangsgröße leeren oder den Wert berichtigen.</translation>
    </message>
    <message>
        <source>this line has {} columns, more than {}</source>
        <translation>diese Zeile hat {} Spalten, mehr als {}</translation>
    </message>
    <message>
        <source>the header has {} columns, more than {}</source>
        <translation>die Kopfzeile hat {} Spalten, mehr als {}</translation>
    </message>
    <message>
        <source>Export fewer channels, or check the mark between the columns.</source>
        <translation>Weniger Kanäle exportieren oder das Trennzeichen der Spalten prüfen.</translation>
    </message>
    <message>
        <source>a column has a name of {} bytes, more than {}: '{}'</source>
        <translation>eine Spalte hat einen Namen von {} Byte, mehr als {}: „{}“</translation>
    </message>
    <message>
        <source>Check the mark between the columns.</source>
        <translation>Das Trennzeichen der Spalten prüfen.</translation>
    </message>
    <message>
        <source>{} further columns have the name of another one</source>
        <translation>{} weitere Spalten heißen wie eine andere</translation>
    </message>
    <message>
        <source>They are called by that name and a number behind it.</source>
        <translation>Sie heißen hier nach ihr mit einer Nummer dahinter.</translation>
    </message>
    <message>
        <source>the table of {:.3g} rows and {} columns</source>
        <translation>die Tabelle von {:.3g} Zeilen und {} Spalten</translation>
    </message>
    <message>
        <source>the file has more than {} rows</source>
        <translation>die Datei hat mehr als {} Zeilen</translation>
    </message>
    <message>
        <source>Split the recording, or record fewer samples a second.</source>
        <translation>Die Aufzeichnung teilen oder weniger Werte je Sekunde aufnehmen.</translation>
    </message>
    <message>
        <source>the time in column '{}' stands still at {}</source>
        <translation>die Zeit in Spalte „{}“ bleibt bei {} stehen</translation>
    </message>
    <message>
        <source>Name the column that holds the time in seconds.</source>
        <translation>Die Spalte nennen, die die Zeit in Sekunden enthält.</translation>
    </message>
    <message>
        <source>this is not a text file</source>
        <translation>dies ist keine Textdatei</translation>
    </message>
    <message>
        <source>Export the measurement as comma-separated values.</source>
        <translation>Die Messung als kommagetrennte Werte exportieren.</translation>
    </message>
    <message>
        <source>the file has a header and no data rows</source>
        <translation>die Datei hat eine Kopfzeile und keine Datenzeilen</translation>
    </message>
    <message>
        <source>Check that the recording was exported with its values.</source>
        <translation>Prüfen, ob die Aufzeichnung mit ihren Werten exportiert wurde.</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>the file has no header</source>
        <translation>die Datei hat keine Kopfzeile</translation>
    </message>
    <message>
        <source>Its columns are called {} to {}.</source>
        <translation>Ihre Spalten heißen {} bis {}.</translation>
    </message>
    <message>
        <source>a quotation mark is opened and not closed on its line</source>
        <translation>ein Anführungszeichen wird geöffnet und in seiner Zeile nicht geschlossen</translation>
    </message>
    <message>
        <source>Close it, or double it where the mark itself is meant.</source>
        <translation>Es schließen, oder verdoppeln, wo das Zeichen selbst gemeint ist.</translation>
    </message>
    <message>
        <source>there are several columns named '{}'</source>
        <translation>es gibt mehrere Spalten namens „{}“</translation>
    </message>
    <message>
        <source>This one is called '{}' here.</source>
        <translation>Diese heißt hier „{}“.</translation>
    </message>
    <message>
        <source>Every row needs one cell for each column of the header.</source>
        <translation>Jede Zeile braucht für jede Spalte der Kopfzeile eine Zelle.</translation>
    </message>
    <message>
        <source> If the commas are decimal marks, the columns must be separated by ; or a tab.</source>
        <translation> Sind die Kommas Dezimalkommas, so müssen die Spalten durch ; oder einen Tabulator getrennt sein.</translation>
    </message>
    <message>
        <source>this row has one cell, the header has {}</source>
        <translation>diese Zeile hat eine Zelle, die Kopfzeile hat {}</translation>
    </message>
    <message>
        <source>this row has {} cells, the header has {}</source>
        <translation>diese Zeile hat {} Zellen, die Kopfzeile hat {}</translation>
    </message>
    <message>
        <source>'{}' in column '{}' has a decimal comma, line {} has a decimal point</source>
        <translation>„{}“ in Spalte „{}“ hat ein Dezimalkomma, Zeile {} einen Dezimalpunkt</translation>
    </message>
    <message>
        <source>'{}' in column '{}' has a decimal point, line {} has a decimal comma</source>
        <translation>„{}“ in Spalte „{}“ hat einen Dezimalpunkt, Zeile {} ein Dezimalkomma</translation>
    </message>
    <message>
        <source>Write the whole file with one decimal mark.</source>
        <translation>Die ganze Datei mit einem Dezimalzeichen schreiben.</translation>
    </message>
    <message>
        <source>Only numbers can be read; leave the cell empty where nothing was measured.</source>
        <translation>Nur Zahlen können gelesen werden; die Zelle leer lassen, wo nichts gemessen wurde.</translation>
    </message>
    <message>
        <source>Marks between thousands cannot be read: write 1234.5.</source>
        <translation>Zeichen zwischen Tausendern können nicht gelesen werden: 1234.5 schreiben.</translation>
    </message>
    <message>
        <source>'{}' in column '{}' is not a number</source>
        <translation>„{}“ in Spalte „{}“ ist keine Zahl</translation>
    </message>
    <message>
        <source>'{}' may be {:.10g} or {:.10g}: nothing in the file tells whether its mark stands for decimals or between thousands</source>
        <translation>„{}“ kann {:.10g} oder {:.10g} sein: Nichts in der Datei sagt, ob das Zeichen Dezimalzeichen ist oder Tausender trennt</translation>
    </message>
    <message>
        <source>Say it in the study: "read": {{"decimal": "{}"}} for {:.10g}, "read": {{"thousands": "{}"}} for {:.10g}.</source>
        <translation>Sagen Sie es in der Studie: "read": {{"decimal": "{}"}} für {:.10g}, "read": {{"thousands": "{}"}} für {:.10g}.</translation>
    </message>
    <message>
        <source>the lines {} to {} are a table of the same shape as the one below: there are two recordings in this file</source>
        <translation>die Zeilen {} bis {} sind eine Tabelle von derselben Form wie die darunter: In dieser Datei sind zwei Aufzeichnungen</translation>
    </message>
    <message>
        <source>Split the file; or leave the first one out in the study: "read": {{"skip": {}}}.</source>
        <translation>Teilen Sie die Datei, oder lassen Sie die erste in der Studie aus: "read": {{"skip": {}}}.</translation>
    </message>
    <message>
        <source>The header stands here again: split the file in front of this line, it holds two recordings.</source>
        <translation>Der Kopf steht hier noch einmal: Teilen Sie die Datei vor dieser Zeile, sie enthält zwei Aufzeichnungen.</translation>
    </message>
    <message>
        <source>Another table seems to begin here: keep one in the file, or export each recording to a file of its own.</source>
        <translation>Hier scheint eine weitere Tabelle zu beginnen: Lassen Sie eine in der Datei, oder exportieren Sie jede Aufzeichnung in eine eigene Datei.</translation>
    </message>
    <message>
        <source>the lines from here on are no rows of the table and are left out: '{}' stands in front</source>
        <translation>die Zeilen von hier an gehören nicht zur Tabelle und werden ausgelassen: vorn steht „{}“</translation>
    </message>
    <message>
        <source>A unit stands in the cell: write it in the header and numbers in the cells.</source>
        <translation>In der Zelle steht eine Einheit: Schreiben Sie sie in den Kopf und Zahlen in die Zellen.</translation>
    </message>
    <message>
        <source>the numbers in column '{}' are taken for {} since 1970: no unit is given</source>
        <translation>die Zahlen in Spalte „{}“ werden als {} seit 1970 gelesen: Es ist keine Einheit angegeben</translation>
    </message>
    <message>
        <source>the time in column '{}' begins at {:.9g} and has no unit: these may be seconds or days</source>
        <translation>die Zeit in Spalte „{}“ beginnt bei {:.9g} und hat keine Einheit: Es können Sekunden oder Tage sein</translation>
    </message>
    <message>
        <source>Say it in the study: "read": {{"time_format": "s"}} or {{"time_format": "d"}}.</source>
        <translation>Geben Sie es in der Studie an: "read": {{"time_format": "s"}} oder {{"time_format": "d"}}.</translation>
    </message>
    <message>
        <source>the words '{}' and '{}' in column '{}' are read as 0 and 1</source>
        <translation>die Wörter „{}“ und „{}“ in Spalte „{}“ werden als 0 und 1 gelesen</translation>
    </message>
    <message>
        <source>column '{}' tells units for '{}' that cannot be converted into each other: {}</source>
        <translation>Spalte „{}“ nennt für „{}“ Einheiten, die sich nicht ineinander umrechnen lassen: {}</translation>
    </message>
    <message>
        <source>Export one quantity a column.</source>
        <translation>Exportieren Sie eine Größe je Spalte.</translation>
    </message>
    <message>
        <source>the unit of column '{}' changes from row to row ({}): all its numbers are in {} now</source>
        <translation>die Einheit von Spalte „{}“ wechselt von Zeile zu Zeile ({}): Alle Zahlen sind nun in {}</translation>
    </message>
    <message>
        <source>"decimal" and "thousands" are the same mark</source>
        <translation>"decimal" und "thousands" sind dasselbe Zeichen</translation>
    </message>
    <message>
        <source>no rows of numbers are found in this text</source>
        <translation>in diesem Text sind keine Zeilen mit Zahlen zu finden</translation>
    </message>
    <message>
        <source>Is it a measurement? If it is, tell the study how it is written: "read": {{"separator": …, "decimal": …, "skip": lines before the header}}.</source>
        <translation>Ist es eine Messung? Dann sagen Sie in der Studie, wie sie geschrieben ist: "read": {{"separator": …, "decimal": …, "skip": Zeilen vor dem Kopf}}.</translation>
    </message>
    <message>
        <source>the unit 'C' of column '{}' is taken for degC, not for coulomb</source>
        <translation>die Einheit „C“ von Spalte „{}“ wird als degC gelesen, nicht als Coulomb</translation>
    </message>
    <message>
        <source>Where it is a charge, give the unit in the study as {{"column": …, "unit": "A.s"}}.</source>
        <translation>Ist es eine Ladung, geben Sie die Einheit in der Studie an: {{"column": …, "unit": "A.s"}}.</translation>
    </message>
    <message>
        <source>tabs</source>
        <translation>Tabulatoren</translation>
    </message>
    <message>
        <source>blanks</source>
        <translation>Leerzeichen</translation>
    </message>
    <message>
        <source>names in line {}</source>
        <translation>Namen in Zeile {}</translation>
    </message>
    <message>
        <source>no header</source>
        <translation>kein Kopf</translation>
    </message>
    <message>
        <source>, units in line {}</source>
        <translation>, Einheiten in Zeile {}</translation>
    </message>
    <message>
        <source>, data from line {}</source>
        <translation>, Daten ab Zeile {}</translation>
    </message>
    <message>
        <source>, {} between the columns</source>
        <translation>, {} zwischen den Spalten</translation>
    </message>
    <message>
        <source>, decimal mark '{}'</source>
        <translation>, Dezimalzeichen „{}“</translation>
    </message>
    <message>
        <source>, '{}' between thousands</source>
        <translation>, „{}“ zwischen Tausendern</translation>
    </message>
    <message>
        <source>this is neither a number of a table nor the head of one</source>
        <translation>das ist weder eine Zahl einer Tabelle noch der Kopf einer Tabelle</translation>
    </message>
    <message>
        <source>this table file declares no table</source>
        <translation>diese Tabellendatei erklärt keine Tabelle</translation>
    </message>
    <message>
        <source>A table is written as "double name(rows,columns)" and its numbers below.</source>
        <translation>Eine Tabelle schreibt man als "double name(Zeilen,Spalten)" und darunter ihre Zahlen.</translation>
    </message>
    <message>
        <source>table '{}' ends after {} of {} numbers</source>
        <translation>Tabelle „{}“ endet nach {} von {} Zahlen</translation>
    </message>
    <message>
        <source>table '{}' has more than {} numbers</source>
        <translation>Tabelle „{}“ hat mehr als {} Zahlen</translation>
    </message>
    <message>
        <source>{} switch between 0 and 1 and the rows come at uneven times: they seem to be written when something changes</source>
        <translation>{} schalten zwischen 0 und 1, und die Zeilen folgen ungleichmäßig: Sie scheinen geschrieben zu werden, wenn sich etwas ändert</translation>
    </message>
    <message>
        <source>As inputs they are held from row to row with "interpolation": "hold".</source>
        <translation>Als Eingänge werden sie mit "interpolation": "hold" von Zeile zu Zeile gehalten.</translation>
    </message>
    <message>
        <source>{} columns of time: {}</source>
        <translation>{} Zeitspalten: {}</translation>
    </message>
    <message>
        <source>each channel belongs to the one on its left</source>
        <translation>jeder Kanal gehört zu der links von ihm</translation>
    </message>
    <message>
        <source>each channel belongs to the one on its right</source>
        <translation>jeder Kanal gehört zu der rechts von ihm</translation>
    </message>
    <message>
        <source>each channel belongs to the one that is as long</source>
        <translation>jeder Kanal gehört zu der, die so lang ist wie er</translation>
    </message>
    <message>
        <source>each channel has the time on its left</source>
        <translation>jeder Kanal hat die Zeit links von ihm</translation>
    </message>
    <message>
        <source>each channel has the time on its right</source>
        <translation>jeder Kanal hat die Zeit rechts von ihm</translation>
    </message>
    <message>
        <source>all channels have '{}'</source>
        <translation>alle Kanäle haben „{}“</translation>
    </message>
    <message>
        <source>'{}' and '{}' are both times and differ. Which channels have which?</source>
        <translation>„{}“ und „{}“ sind beide Zeiten und verschieden. Welche Kanäle haben welche?</translation>
    </message>
    <message>
        <source>'{}' and '{}' are both times and differ; all channels are taken to have '{}'</source>
        <translation>„{}“ und „{}“ sind beide Zeiten und verschieden; für alle Kanäle gilt „{}“</translation>
    </message>
    <message>
        <source>Where channels have times of their own, say it in the study: "read": {{"times": "left"}}, or "right".</source>
        <translation>Wo Kanäle eigene Zeiten haben, in der Studie sagen: "read": {{"times": "left"}} oder "right".</translation>
    </message>
    <message>
        <source>{} at {:.10g} {}</source>
        <translation>{} bei {:.10g} {}</translation>
    </message>
    <message>
        <source>one, left or right</source>
        <translation>one, left oder right</translation>
    </message>
    <message>
        <source>from {:.6g} s to {:.6g} s every channel was recorded; {} of {} stamps lie outside and are not shown</source>
        <translation>von {:.6g} s bis {:.6g} s ist jeder Kanal aufgezeichnet; {} von {} Zeitpunkten liegen außerhalb und werden nicht gezeigt</translation>
    </message>
    <message>
        <source>The channel '{}' is recorded for a shorter time.</source>
        <translation>Der Kanal „{}“ ist über eine kürzere Zeit aufgezeichnet.</translation>
    </message>
    <message>
        <source>no bounds are given for {}; what is positive is looked for within a factor of 1000 of its start value</source>
        <translation>für {} sind keine Grenzen angegeben; was positiv ist, wird innerhalb eines Faktors 1000 um seinen Startwert gesucht</translation>
    </message>
    <message>
        <source>{} parameters, first {}</source>
        <translation>{} Parameter, zuerst {}</translation>
    </message>
    <message>
        <source>the stamps in column '{}' have too few digits: about {} rows share each; they are laid on an even raster of {:.6g} {}</source>
        <translation>die Zeitstempel in Spalte „{}“ haben zu wenige Stellen: Je etwa {} Zeilen haben denselben; sie werden auf ein gleichmäßiges Raster von {:.6g} {} gelegt</translation>
    </message>
    <message>
        <source>Export the time with more digits, or tell the time between two rows: "read": {{"time_format": "0.001 s"}}.</source>
        <translation>Exportieren Sie die Zeit mit mehr Stellen, oder nennen Sie die Zeit zwischen zwei Zeilen: "read": {{"time_format": "0.001 s"}}.</translation>
    </message>
    <message>
        <source>the time in column '{}' repeats in {} rows and goes on evenly around them: these rows are spread over their gap (lines {})</source>
        <translation>die Zeit in Spalte „{}“ wiederholt sich in {} Zeilen und läuft um sie herum gleichmäßig: Diese Zeilen werden über ihre Lücke verteilt (Zeilen {})</translation>
    </message>
    <message>
        <source>'{}' in column '{}' is no date or clock</source>
        <translation>„{}“ in Spalte „{}“ ist weder Datum noch Uhrzeit</translation>
    </message>
    <message>
        <source>Say how they are written in the study: "read": {{"time_format": "%d.%m.%Y %H:%M:%S"}}.</source>
        <translation>Sagen Sie in der Studie, wie sie geschrieben sind: "read": {{"time_format": "%d.%m.%Y %H:%M:%S"}}.</translation>
    </message>
    <message>
        <source>'{}' in column '{}' is no number with a unit, as the cells above it</source>
        <translation>„{}“ in Spalte „{}“ ist keine Zahl mit Einheit wie die Zellen darüber</translation>
    </message>
    <message>
        <source>Write the unit in the header and numbers in the cells.</source>
        <translation>Schreiben Sie die Einheit in den Kopf und Zahlen in die Zellen.</translation>
    </message>
    <message>
        <source>the cells of column '{}' are in '{}' and in '{}'</source>
        <translation>die Zellen von Spalte „{}“ sind in „{}“ und in „{}“</translation>
    </message>
    <message>
        <source>Export the column in one unit.</source>
        <translation>Exportieren Sie die Spalte in einer Einheit.</translation>
    </message>
    <message>
        <source> A name with a comma needs quotation marks.</source>
        <translation> Ein Name mit Komma braucht Anführungszeichen.</translation>
    </message>
    <message>
        <source>There are exactly twice as many: the commas seem to be decimal marks as well. Export with decimal points, or with ; or a tab between the columns.</source>
        <translation>Es sind genau doppelt so viele: Die Kommas scheinen auch Dezimalzeichen zu sein. Exportieren Sie mit Dezimalpunkten, oder mit ; oder Tabulator zwischen den Spalten.</translation>
    </message>
    <message>
        <source>column '{}' was beyond the range of its instrument in line {}</source>
        <translation>Spalte „{}“ lag in Zeile {} außerhalb des Messbereichs</translation>
    </message>
    <message>
        <source>column '{}' was beyond the range of its instrument in {} rows, first in lines {}</source>
        <translation>Spalte „{}“ lag in {} Zeilen außerhalb des Messbereichs, zuerst in Zeile {}</translation>
    </message>
    <message>
        <source>These cells are taken for not measured.</source>
        <translation>Diese Zellen gelten als nicht gemessen.</translation>
    </message>
    <message>
        <source>'{}' is read as a mark between thousands</source>
        <translation>„{}“ wird als Zeichen zwischen Tausendern gelesen</translation>
    </message>
    <message>
        <source>the time is that of columns '{}' and '{}' together</source>
        <translation>die Zeit ist die der Spalten „{}“ und „{}“ zusammen</translation>
    </message>
    <message>
        <source>the milliseconds in column '{}' belong to the time in '{}'</source>
        <translation>die Millisekunden in Spalte „{}“ gehören zur Zeit in „{}“</translation>
    </message>
    <message>
        <source>the time zone '{}' is not known</source>
        <translation>die Zeitzone „{}“ ist nicht bekannt</translation>
    </message>
    <message>
        <source>Write "time_zone" as "Europe/Berlin", "UTC" or "+02:00".</source>
        <translation>Schreiben Sie "time_zone" als "Europe/Berlin", "UTC" oder "+02:00".</translation>
    </message>
    <message>
        <source>have a date and some have none</source>
        <translation>haben ein Datum und manche keines</translation>
    </message>
    <message>
        <source>have a time zone and some have none</source>
        <translation>haben eine Zeitzone und manche keine</translation>
    </message>
    <message>
        <source>some stamps in column '{}' {}</source>
        <translation>manche Zeitstempel in Spalte „{}“ {}</translation>
    </message>
    <message>
        <source>Tell how they are written in the study: "read": {{"time_format": …, "time_zone": …}}.</source>
        <translation>Sagen Sie in der Studie, wie sie geschrieben sind: "read": {{"time_format": …, "time_zone": …}}.</translation>
    </message>
    <message>
        <source>have day and month in another order than others</source>
        <translation>haben Tag und Monat in anderer Reihenfolge als andere</translation>
    </message>
    <message>
        <source>the date {:02}/{:02}/{:02} in column '{}' may have the day or the month in front, and the stamps differ</source>
        <translation>im Datum {:02}/{:02}/{:02} in Spalte „{}“ kann der Tag oder der Monat vorn stehen, und die Zeiten unterscheiden sich</translation>
    </message>
    <message>
        <source>Say it in the study: "read": {{"time_format": "%d/%m/%Y %H:%M:%S"}} or "%m/%d/%Y %H:%M:%S".</source>
        <translation>Sagen Sie es in der Studie: "read": {{"time_format": "%d/%m/%Y %H:%M:%S"}} oder "%m/%d/%Y %H:%M:%S".</translation>
    </message>
    <message>
        <source>the clock in column '{}' goes back by an hour here</source>
        <translation>die Uhr in Spalte „{}“ geht hier um eine Stunde zurück</translation>
    </message>
    <message>
        <source>the clock in column '{}' leaves out the hour from 2 to 3 here: a pause, or summer time</source>
        <translation>die Uhr in Spalte „{}“ lässt hier die Stunde von 2 bis 3 aus: eine Pause oder Sommerzeit</translation>
    </message>
    <message>
        <source>If it is summer time, tell the zone of the clock in the study: "read": {{"time_zone": "Europe/Berlin"}}; if it is not, "time_zone": "UTC".</source>
        <translation>Ist es die Sommerzeit, nennen Sie in der Studie die Zone der Uhr: "read": {{"time_zone": "Europe/Berlin"}}; sonst "time_zone": "UTC".</translation>
    </message>
    <message>
        <source>the clock in column '{}' passes midnight in line {}: a day is added there</source>
        <translation>die Uhr in Spalte „{}“ geht in Zeile {} über Mitternacht: Dort kommt ein Tag hinzu</translation>
    </message>
    <message>
        <source>'{}' in column '{}' may be hours and minutes or minutes and seconds</source>
        <translation>„{}“ in Spalte „{}“ können Stunden und Minuten oder Minuten und Sekunden sein</translation>
    </message>
    <message>
        <source>What is '{}' in column '{}'?</source>
        <translation>Was ist „{}“ in Spalte „{}“?</translation>
    </message>
    <message>
        <source>the channels of this table stand in rows</source>
        <translation>die Kanäle dieser Tabelle stehen in Zeilen</translation>
    </message>
    <message>
        <source>Turn it round, so that each channel is a column with its name on top.</source>
        <translation>Die Tabelle drehen, sodass jeder Kanal eine Spalte mit seinem Namen darüber ist.</translation>
    </message>
    <message>
        <source>date and clock in one number</source>
        <translation>Datum und Uhrzeit in einer Zahl</translation>
    </message>
    <message>
        <source>the time in column '{}' begins at {:.14g} and has no unit: these may be seconds, or {}</source>
        <translation>die Zeit in Spalte „{}“ beginnt bei {:.14g} und hat keine Einheit: Das können Sekunden sein oder {}</translation>
    </message>
    <message>
        <source>Say it in the study: &quot;read&quot;: {{&quot;time_format&quot;: &quot;{}&quot;}} or {{&quot;time_format&quot;: &quot;s&quot;}}.</source>
        <translation>In der Studie steht es so: &quot;read&quot;: {{&quot;time_format&quot;: &quot;{}&quot;}} oder {{&quot;time_format&quot;: &quot;s&quot;}}.</translation>
    </message>
    <message>
        <source>the unit of channel '{}' changes from row to row: {}</source>
        <translation>die Einheit des Kanals „{}“ wechselt von Zeile zu Zeile: {}</translation>
    </message>
    <message>
        <source>each row has one value and tells in column '{}' which channel it belongs to: there are {} channels</source>
        <translation>jede Zeile hat einen Wert und sagt in Spalte „{}“, zu welchem Kanal er gehört: Es sind {} Kanäle</translation>
    </message>
    <message>
        <source>several rows share each stamp, and column '{}' tells them apart: they seem to be rows of several channels</source>
        <translation>mehrere Zeilen teilen sich einen Zeitstempel, und Spalte „{}“ unterscheidet sie: Es scheinen Zeilen mehrerer Kanäle zu sein</translation>
    </message>
    <message>
        <source>Export one column a channel, or call the columns &quot;{}&quot; and &quot;{}&quot;.</source>
        <translation>Für jeden Kanal eine Spalte exportieren, oder die Spalten „{}“ und „{}“ nennen.</translation>
    </message>
    <message>
        <source>count days and some do not</source>
        <translation>zählen Tage und manche nicht</translation>
    </message>
    <message>
        <source>days, hours, minutes and seconds</source>
        <translation>Tage, Stunden, Minuten und Sekunden</translation>
    </message>
    <message>
        <source>hours, minutes, seconds and hundredths</source>
        <translation>Stunden, Minuten, Sekunden und Hundertstel</translation>
    </message>
    <message>
        <source>'{}' in column '{}' may be days, hours, minutes and seconds, or hours, minutes, seconds and hundredths</source>
        <translation>„{}“ in Spalte „{}“ können Tage, Stunden, Minuten und Sekunden oder Stunden, Minuten, Sekunden und Hundertstel sein</translation>
    </message>
    <message>
        <source>Say it in the study: &quot;read&quot;: {{&quot;time_format&quot;: &quot;%j:%H:%M:%S&quot;}} or &quot;%H:%M:%S:%f&quot;.</source>
        <translation>In der Studie steht es so: &quot;read&quot;: {{&quot;time_format&quot;: &quot;%j:%H:%M:%S&quot;}} oder &quot;%H:%M:%S:%f&quot;.</translation>
    </message>
    <message>
        <source>hours, minutes and seconds in one number</source>
        <translation>Stunden, Minuten und Sekunden in einer Zahl</translation>
    </message>
    <message>
        <source>, settings beside the first rows</source>
        <translation>, Einstellungen neben den ersten Zeilen</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is taken for the time of &quot;{}&quot;; &quot;{}&quot; has as many values</source>
        <translation>„{}“ gilt als Zeit von „{}“; „{}“ hat ebenso viele Werte</translation>
    </message>
    <message>
        <source>sheet &quot;{}&quot;, column &quot;{}&quot;: its numbers are written as text, and their mark may stand for decimals or between thousands: write them as numbers</source>
        <translation>Blatt „{}“, Spalte „{}“: Die Zahlen sind als Text geschrieben, und ihr Zeichen kann für Dezimalen oder zwischen Tausendern stehen: als Zahlen schreiben</translation>
    </message>
    <message>
        <source>hours and minutes</source>
        <translation>Stunden und Minuten</translation>
    </message>
    <message>
        <source>minutes and seconds</source>
        <translation>Minuten und Sekunden</translation>
    </message>
    <message>
        <source>Which day is '{}'?</source>
        <translation>Welcher Tag ist „{}“?</translation>
    </message>
    <message>
        <source>year, month, day</source>
        <translation>Jahr, Monat, Tag</translation>
    </message>
    <message>
        <source>day, month, year</source>
        <translation>Tag, Monat, Jahr</translation>
    </message>
    <message>
        <source>month, day, year</source>
        <translation>Monat, Tag, Jahr</translation>
    </message>
    <message>
        <source>The clock in column '{}' jumps by an hour. Why?</source>
        <translation>Die Uhr in Spalte „{}“ springt um eine Stunde. Warum?</translation>
    </message>
    <message>
        <source>summer time begins or ends here ({})</source>
        <translation>Hier beginnt oder endet die Sommerzeit ({})</translation>
    </message>
    <message>
        <source>the clock knows no summer time ({})</source>
        <translation>Die Uhr kennt keine Sommerzeit ({})</translation>
    </message>
    <message>
        <source>In which unit is the time in column '{}', which begins at {:.9g}?</source>
        <translation>In welcher Einheit ist die Zeit in Spalte „{}“, die bei {:.9g} beginnt?</translation>
    </message>
    <message>
        <source>seconds</source>
        <translation>Sekunden</translation>
    </message>
    <message>
        <source>days</source>
        <translation>Tage</translation>
    </message>
    <message>
        <source>milliseconds</source>
        <translation>Millisekunden</translation>
    </message>
    <message>
        <source>microseconds</source>
        <translation>Mikrosekunden</translation>
    </message>
    <message>
        <source>nanoseconds</source>
        <translation>Nanosekunden</translation>
    </message>
    <message>
        <source>Which time lies between two rows?</source>
        <translation>Welche Zeit liegt zwischen zwei Zeilen?</translation>
    </message>
    <message>
        <source>Does the mark in '{}' stand for decimals or between thousands?</source>
        <translation>Steht das Zeichen in „{}“ vor den Nachkommastellen oder zwischen Tausendern?</translation>
    </message>
    <message>
        <source>'{}' is {:.10g}</source>
        <translation>„{}“ ist {:.10g}</translation>
    </message>
    <message>
        <source>There are two recordings in this file. Which one is meant?</source>
        <translation>In dieser Datei sind zwei Messungen. Welche ist gemeint?</translation>
    </message>
    <message>
        <source>the one below line {}</source>
        <translation>die unter Zeile {}</translation>
    </message>
    <message>
        <source>{:.10g}</source>
        <translation>{:.10g}</translation>
    </message>
    <message>
        <source>{:.10g} {}</source>
        <translation>{:.10g} {}</translation>
    </message>
    <message>
        <source>the shift in time cannot be told: {}</source>
        <translation>Die zeitliche Verschiebung lässt sich nicht angeben: {}</translation>
    </message>
    <message>
        <source>the course changes so slowly that shifts over {:.3g} s do equally well</source>
        <translation>Der Verlauf ändert sich so langsam, dass Verschiebungen über {:.3g} s gleich gut passen</translation>
    </message>
    <message>
        <source>the course repeats: one that differs by {:.4g} s does as well</source>
        <translation>Der Verlauf wiederholt sich: Eine um {:.4g} s andere passt ebenso gut</translation>
    </message>
    <message>
        <source>the two overlap by less than half of the shorter one</source>
        <translation>Die beiden überdecken sich um weniger als die Hälfte der kürzeren</translation>
    </message>
    <message>
        <source>less than {} samples were measured</source>
        <translation>Es wurden weniger als {} Werte gemessen</translation>
    </message>
    <message>
        <source>one of the two does not change</source>
        <translation>Eine der beiden ändert sich nicht</translation>
    </message>
    <message>
        <source>the two are not alike (correlation {:.2f} at best)</source>
        <translation>Die beiden gleichen sich nicht (Korrelation höchstens {:.2f})</translation>
    </message>
    <message>
        <source>Say it in the study: "read": {{"time_format": "%H:%M"}} or "%M:%S".</source>
        <translation>Sagen Sie es in der Studie: "read": {{"time_format": "%H:%M"}} oder "%M:%S".</translation>
    </message>
    <message>
        <source>no column is a time of the form '{}'</source>
        <translation>keine Spalte ist eine Zeit der Form „{}“</translation>
    </message>
    <message>
        <source>"time_format" is written as "%d.%m.%Y %H:%M:%S", or as the time between two rows: "0.001 s".</source>
        <translation>"time_format" schreibt man als "%d.%m.%Y %H:%M:%S" oder als Zeit zwischen zwei Zeilen: "0.001 s".</translation>
    </message>
    <message>
        <source>"{}" of "read" is not known here</source>
        <translation>"{}" von "read" ist hier nicht bekannt</translation>
    </message>
    <message>
        <source>It is , ; | a tab or a blank.</source>
        <translation>Es ist , ; | ein Tabulator oder ein Leerzeichen.</translation>
    </message>
    <message>
        <source>It is . or ,</source>
        <translation>Es ist . oder ,</translation>
    </message>
    <message>
        <source>It is . , ' or a blank.</source>
        <translation>Es ist . , ' oder ein Leerzeichen.</translation>
    </message>
    <message>
        <source>It is utf-8, utf-16le, utf-16be, utf-32le, utf-32be, windows-1252 or iso-8859-1.</source>
        <translation>Es ist utf-8, utf-16le, utf-16be, utf-32le, utf-32be, windows-1252 oder iso-8859-1.</translation>
    </message>
    <message>
        <source>a table of the Modelica Standard Library: its columns have no names and are called by their numbers, the first is the time in seconds</source>
        <translation>eine Tabelle der Modelica-Standardbibliothek: Ihre Spalten haben keine Namen und heißen nach ihren Nummern, die erste ist die Zeit in Sekunden</translation>
    </message>
    <message>
        <source>, letters of Windows-1252</source>
        <translation>, Buchstaben von Windows-1252</translation>
    </message>
    <message>
        <source>no unit is given for {}</source>
        <translation>ohne Einheit: {}</translation>
    </message>
    <message>
        <source>no unit is given for {} columns, first {}</source>
        <translation>{} Spalten ohne Einheit, zuerst {}</translation>
    </message>
    <message>
        <source>the lines in front of the table tell {:.6g} s between two rows, the column '{}' has {:.6g} s</source>
        <translation>die Zeilen vor der Tabelle nennen {:.6g} s zwischen zwei Zeilen, die Spalte „{}“ hat {:.6g} s</translation>
    </message>
    <message>
        <source>no column is a time; '{}' counts the rows</source>
        <translation>keine Spalte ist eine Zeit; „{}“ zählt die Zeilen</translation>
    </message>
    <message>
        <source>; the channels have several sample intervals</source>
        <translation>; die Kanäle haben verschiedene Abtastabstände</translation>
    </message>
    <message>
        <source>Tell the time between two rows in the study: "read": {{"time_format": "0.001 s"}}, or as a rate: "1 kHz".</source>
        <translation>Nennen Sie in der Studie die Zeit zwischen zwei Zeilen: "read": {{"time_format": "0.001 s"}}, oder als Rate: "1 kHz".</translation>
    </message>
    <message>
        <source>the time is made of {:.6g} s from one row to the next, as it was told</source>
        <translation>die Zeit entsteht aus {:.6g} s von Zeile zu Zeile, wie angegeben</translation>
    </message>
    <message>
        <source>the time is made of {:.6g} s from one row to the next and a start at {:.6g} s, as the lines in front of the table tell</source>
        <translation>die Zeit entsteht aus {:.6g} s von Zeile zu Zeile und dem Beginn bei {:.6g} s, wie die Zeilen vor der Tabelle sagen</translation>
    </message>
    <message>
        <source>the recording pauses for {:.6g} {} before line {}; its usual step is {:.6g} {} ({} such pauses in all)</source>
        <translation>die Aufzeichnung pausiert {:.6g} {} vor Zeile {}; ihr üblicher Schritt ist {:.6g} {} ({} solche Pausen insgesamt)</translation>
    </message>
    <message>
        <source>{} ({})</source>
        <translation>{} ({})</translation>
    </message>
    <message>
        <source>this cannot be read: {}</source>
        <translation>dies lässt sich nicht lesen: {}</translation>
    </message>
    <message>
        <source>reading was stopped</source>
        <translation>das Lesen wurde angehalten</translation>
    </message>
    <message>
        <source>variable &quot;{}&quot; cannot be read</source>
        <translation>Variable „{}“ lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>the file is damaged: it cannot be opened</source>
        <translation>die Datei ist beschädigt: sie lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>column '{}' has no unit and its name ends in '{}': its numbers are taken to be in '{}', as the model wants them</source>
        <translation>Spalte „{}“ hat keine Einheit, und ihr Name endet auf „{}“: Ihre Zahlen werden in „{}“ genommen, wie das Modell sie will</translation>
    </message>
    <message>
        <source>Say which it is in the study: {{&quot;column&quot;: &quot;{}&quot;, &quot;unit&quot;: &quot;{}&quot;}} or {{&quot;column&quot;: &quot;{}&quot;, &quot;unit&quot;: &quot;{}&quot;}}.</source>
        <translation>Sagen Sie in der Studie, was gilt: {{&quot;column&quot;: &quot;{}&quot;, &quot;unit&quot;: &quot;{}&quot;}} oder {{&quot;column&quot;: &quot;{}&quot;, &quot;unit&quot;: &quot;{}&quot;}}.</translation>
    </message>
    <message>
        <source>the time in column '{}' is taken in {}, as its name says</source>
        <translation>die Zeit in Spalte „{}“ wird in {} genommen, wie ihr Name sagt</translation>
    </message>
    <message>
        <source>the time in column '{}' goes back in line {}: the rows are not in their order</source>
        <translation>die Zeit in Spalte „{}“ geht in Zeile {} zurück: Die Zeilen sind nicht in ihrer Reihenfolge</translation>
    </message>
    <message>
        <source>minutes</source>
        <translation>Minuten</translation>
    </message>
    <message>
        <source>, names in front of the numbers</source>
        <translation>, Namen vor den Zahlen</translation>
    </message>
    <message>
        <source>the file is packed ({})</source>
        <translation>die Datei ist gepackt ({})</translation>
    </message>
    <message>
        <source>Unpack it, and take the file that is in it.</source>
        <translation>Entpacken Sie sie und nehmen Sie die Datei, die darin ist.</translation>
    </message>
    <message>
        <source>the file is damaged: it cannot be read as MATLAB 7.3</source>
        <translation>die Datei ist beschädigt: sie lässt sich nicht als MATLAB 7.3 lesen</translation>
    </message>
    <message>
        <source>the file is damaged: it cannot be read as a MATLAB file</source>
        <translation>die Datei ist beschädigt: sie lässt sich nicht als MATLAB-Datei lesen</translation>
    </message>
    <message>
        <source>the file is damaged or ends too early: it begins as MATLAB 7.3 and cannot be opened</source>
        <translation>die Datei ist beschädigt oder endet zu früh: Sie beginnt wie MATLAB 7.3 und lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>copy it again from where it was recorded</source>
        <translation>sie noch einmal von dort kopieren, wo sie aufgezeichnet wurde</translation>
    </message>
    <message>
        <source>no channels: {}</source>
        <translation>keine Kanäle: {}</translation>
    </message>
    <message>
        <source>the file holds no channel with values</source>
        <translation>die Datei enthält keinen Kanal mit Werten</translation>
    </message>
    <message>
        <source>channel &quot;{}&quot;: its fields scale and offset are applied, data*{} + {}</source>
        <translation>Kanal „{}“: seine Felder scale und offset sind angewandt, data*{} + {}</translation>
    </message>
    <message>
        <source>variable &quot;{}&quot; is an object ({}) that only MATLAB can read; there: {}</source>
        <translation>Variable „{}“ ist ein Objekt ({}), das nur MATLAB lesen kann; dort: {}</translation>
    </message>
    <message>
        <source>group &quot;{}&quot; has no time: its samples can only be counted</source>
        <translation>Gruppe „{}“ hat keine Zeit: ihre Werte können nur gezählt werden</translation>
    </message>
    <message>
        <source>the file ends in the middle of a variable</source>
        <translation>die Datei endet mitten in einer Variablen</translation>
    </message>
    <message>
        <source>no variable is in this file</source>
        <translation>in dieser Datei ist keine Variable</translation>
    </message>
    <message>
        <source>the file is damaged: the lengths in it contradict each other</source>
        <translation>die Datei ist beschädigt: die Längen darin widersprechen einander</translation>
    </message>
    <message>
        <source>the file ends behind its identification: no measurement is in it</source>
        <translation>die Datei endet nach ihrer Kennung: sie enthält keine Messung</translation>
    </message>
    <message>
        <source>MDF version &quot;{}&quot; is not known</source>
        <translation>MDF-Version „{}“ ist nicht bekannt</translation>
    </message>
    <message>
        <source>versions 2 to 4.2 can be read</source>
        <translation>die Versionen 2 bis 4.2 können gelesen werden</translation>
    </message>
    <message>
        <source>the header of the file is damaged</source>
        <translation>der Kopf der Datei ist beschädigt</translation>
    </message>
    <message>
        <source>the recorder did not close the file: what it had written is read</source>
        <translation>das Messgerät hat die Datei nicht abgeschlossen: was es geschrieben hatte, ist gelesen</translation>
    </message>
    <message>
        <source>the file is damaged: its blocks refer to each other in a circle</source>
        <translation>die Datei ist beschädigt: ihre Blöcke verweisen im Kreis aufeinander</translation>
    </message>
    <message>
        <source>the file is damaged: no block of the expected kind at byte {}</source>
        <translation>die Datei ist beschädigt: bei Byte {} liegt kein Block der erwarteten Art</translation>
    </message>
    <message>
        <source>a group is left out: {} record ids for each record cannot be</source>
        <translation>eine Gruppe ist ausgelassen: {} Kennungen je Datensatz kann es nicht geben</translation>
    </message>
    <message>
        <source>channel &quot;{}&quot; is left out: values of type {} cannot be read</source>
        <translation>Kanal „{}“ ist ausgelassen: Werte der Art {} können nicht gelesen werden</translation>
    </message>
    <message>
        <source>group &quot;{}&quot; has no samples</source>
        <translation>Gruppe „{}“ hat keine Werte</translation>
    </message>
    <message>
        <source>the file is damaged: names, units or comments are missing</source>
        <translation>die Datei ist beschädigt: Namen, Einheiten oder Kommentare fehlen</translation>
    </message>
    <message>
        <source>a group is left out: record ids of {} bytes cannot be</source>
        <translation>eine Gruppe ist ausgelassen: Kennungen von {} Byte kann es nicht geben</translation>
    </message>
    <message>
        <source>array &quot;{}&quot; is left out: its form cannot be read</source>
        <translation>Feld „{}“ ist ausgelassen: seine Form lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>channel &quot;{}&quot;: the file marks all its values as invalid</source>
        <translation>Kanal „{}“: die Datei erklärt alle seine Werte für ungültig</translation>
    </message>
    <message>
        <source>the file ends in the middle of its data (a broken copy?)</source>
        <translation>die Datei endet mitten in ihren Daten (eine abgebrochene Kopie?)</translation>
    </message>
    <message>
        <source>the file is damaged: a part of its data is left out</source>
        <translation>die Datei ist beschädigt: ein Teil ihrer Daten ist ausgelassen</translation>
    </message>
    <message>
        <source>group &quot;{}&quot; holds {} raw frames of the bus {}, no signals: decode them with the bus's database (DBC, ARXML) in the recording tool and export the signals</source>
        <translation>Gruppe „{}“ enthält {} rohe Botschaften des Busses {}, keine Signale: sie im Messprogramm mit der Datenbank des Busses (DBC, ARXML) entschlüsseln und die Signale exportieren</translation>
    </message>
    <message>
        <source>channel &quot;{}&quot;: its conversion &quot;{}&quot; cannot be read, its values are those of the record</source>
        <translation>Kanal „{}“: seine Umrechnung „{}“ lässt sich nicht lesen, seine Werte sind die rohen</translation>
    </message>
    <message>
        <source>channel &quot;{}&quot;: values that have a text in place of a number (such as &quot;{}&quot;) are gaps</source>
        <translation>Kanal „{}“: Werte, die statt einer Zahl einen Text haben (wie „{}“), sind Lücken</translation>
    </message>
    <message>
        <source>channel &quot;{}&quot; is left out: {} bits cannot be a value of its type</source>
        <translation>Kanal „{}“ ist ausgelassen: {} Bit können kein Wert seiner Art sein</translation>
    </message>
    <message>
        <source>channel &quot;{}&quot; is left out: it lies outside its record</source>
        <translation>Kanal „{}“ ist ausgelassen: er liegt außerhalb seines Datensatzes</translation>
    </message>
    <message>
        <source>the texts of a channel are missing in the file, or too long</source>
        <translation>die Texte eines Kanals fehlen in der Datei oder sind zu lang</translation>
    </message>
    <message>
        <source>a packed block is damaged: {} samples are lost and read as gaps</source>
        <translation>ein gepackter Block ist beschädigt: {} Werte sind verloren und als Lücken gelesen</translation>
    </message>
    <message>
        <source>the data end after {} of {} samples: what follows is damaged or missing</source>
        <translation>die Daten enden nach {} von {} Werten: was folgt, ist beschädigt oder fehlt</translation>
    </message>
    <message>
        <source>whole numbers above 2^53 were rounded to 53 bits</source>
        <translation>ganze Zahlen über 2^53 wurden auf 53 Bit gerundet</translation>
    </message>
    <message>
        <source>group &quot;{}&quot;: {} samples without data cannot be</source>
        <translation>Gruppe „{}“: {} Werte ohne Daten kann es nicht geben</translation>
    </message>
    <message>
        <source>group &quot;{}&quot;: the last record is incomplete ({} of {} bytes) and left out</source>
        <translation>Gruppe „{}“: der letzte Datensatz ist unvollständig ({} von {} Byte) und ausgelassen</translation>
    </message>
    <message>
        <source>group &quot;{}&quot;: {} of {} samples are there, the file is shorter than it says (a broken copy?)</source>
        <translation>Gruppe „{}“: {} von {} Werten sind da, die Datei ist kürzer, als sie angibt (eine abgebrochene Kopie?)</translation>
    </message>
    <message>
        <source>group &quot;{}&quot;: data of {} samples are there, {} are told and read</source>
        <translation>Gruppe „{}“: Daten von {} Werten sind da, {} sind angegeben und gelesen</translation>
    </message>
    <message>
        <source>group &quot;{}&quot;: {} samples are told, {} are there and read</source>
        <translation>Gruppe „{}“: {} Werte sind angegeben, {} sind da und gelesen</translation>
    </message>
    <message>
        <source>this file is of no kind that can be read</source>
        <translation>diese Datei ist von keiner Art, die gelesen werden kann</translation>
    </message>
    <message>
        <source>ASAM MDF, MATLAB, TDMS, XLSX and text tables can be read: export the recording as one of them</source>
        <translation>ASAM MDF, MATLAB, TDMS, XLSX und Texttabellen können gelesen werden: die Aufzeichnung als eines davon exportieren</translation>
    </message>
    <message>
        <source>group &quot;{}&quot;: its master jumps back {} times, first at sample {}</source>
        <translation>Gruppe „{}“: ihre Leitgröße springt {}-mal zurück, zuerst bei Wert {}</translation>
    </message>
    <message>
        <source>group &quot;{}&quot;: {} stamps of its master repeat the one before, first at sample {}</source>
        <translation>Gruppe „{}“: {} Stempel ihrer Leitgröße wiederholen den vorigen, zuerst bei Wert {}</translation>
    </message>
    <message>
        <source>group &quot;{}&quot;: {} stamps of its master are no finite numbers</source>
        <translation>Gruppe „{}“: {} Stempel ihrer Leitgröße sind keine endlichen Zahlen</translation>
    </message>
    <message>
        <source>no column is a time by its unit or its name</source>
        <translation>keine Spalte ist nach Einheit oder Name eine Zeit</translation>
    </message>
    <message>
        <source>the recorder did not close the file: its last part is incomplete, what is there is read</source>
        <translation>das Messgerät hat die Datei nicht abgeschlossen: ihr letzter Teil ist unvollständig, was da ist, ist gelesen</translation>
    </message>
    <message>
        <source>channel &quot;{}&quot; has no samples</source>
        <translation>Kanal „{}“ hat keine Werte</translation>
    </message>
    <message>
        <source>sheet &quot;{}&quot; has too many cells: the last ones are left out</source>
        <translation>Blatt „{}“ hat zu viele Zellen: die letzten sind ausgelassen</translation>
    </message>
    <message>
        <source>sheet &quot;{}&quot;, column &quot;{}&quot;: numbers that were written as text are read, &quot;{}&quot; as decimal mark</source>
        <translation>Blatt „{}“, Spalte „{}“: Zahlen, die als Text geschrieben sind, sind gelesen, „{}“ als Dezimalzeichen</translation>
    </message>
    <message>
        <source>sheet &quot;{}&quot;, column &quot;{}&quot;: fractions that are shown as percent are read as percent</source>
        <translation>Blatt „{}“, Spalte „{}“: Brüche, die als Prozent angezeigt werden, sind als Prozent gelesen</translation>
    </message>
    <message>
        <source>sheet &quot;{}&quot;, column &quot;{}&quot;: {} cells with words are gaps</source>
        <translation>Blatt „{}“, Spalte „{}“: {} Zellen mit Wörtern sind Lücken</translation>
    </message>
    <message>
        <source>sheet "{}", column "{}": the clock passes midnight {} times: a day is added there</source>
        <translation>Blatt „{}“, Spalte „{}“: Die Uhr geht {}-mal über Mitternacht: Dort kommt jeweils ein Tag hinzu</translation>
    </message>
    <message>
        <source>sheet &quot;{}&quot;, column &quot;{}&quot;: {} formulas have no result in the file and are gaps; open it in a spreadsheet program and save it</source>
        <translation>Blatt „{}“, Spalte „{}“: {} Formeln haben in der Datei kein Ergebnis und sind Lücken; öffnen und speichern Sie sie in einer Tabellenkalkulation</translation>
    </message>
    <message>
        <source>sheet &quot;{}&quot;: what stands below the table, from row {} on, is left out</source>
        <translation>Blatt „{}“: was unter der Tabelle steht, ab Zeile {}, wird ausgelassen</translation>
    </message>
    <message>
        <source>sheet &quot;{}&quot; has {} columns of time: each column belongs to the one on its left</source>
        <translation>Blatt „{}“ hat {} Zeitspalten: jede Spalte gehört zu der links von ihr</translation>
    </message>
    <message>
        <source>sheet &quot;{}&quot;: {} rows without a time at the end are left out</source>
        <translation>Blatt „{}“: {} Zeilen ohne Zeit am Ende sind ausgelassen</translation>
    </message>
    <message>
        <source>the archive is damaged: it cannot be opened</source>
        <translation>das Archiv ist beschädigt: es lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>the archive is damaged: its part '{}' cannot be read as it was written</source>
        <translation>das Archiv ist beschädigt: sein Teil „{}“ lässt sich nicht so lesen, wie er geschrieben wurde</translation>
    </message>
    <message>
        <source>copy it again from where it was saved</source>
        <translation>kopieren Sie es erneut von dort, wo es gespeichert wurde</translation>
    </message>
    <message>
        <source>no Excel workbook is in this archive</source>
        <translation>in diesem Archiv ist keine Excel-Mappe</translation>
    </message>
    <message>
        <source>save the table as .xlsx or as CSV</source>
        <translation>die Tabelle als .xlsx oder als CSV speichern</translation>
    </message>
    <message>
        <source>sheet &quot;{}&quot; has no numbers</source>
        <translation>Blatt „{}“ hat keine Zahlen</translation>
    </message>
    <message>
        <source>no column of numbers is in this workbook ({} sheets looked at)</source>
        <translation>in dieser Mappe ist keine Spalte mit Zahlen ({} Blätter angesehen)</translation>
    </message>
    <message>
        <source>in MATLAB save vectors and their time of one length: save('readable.mat', 't', 'y')</source>
        <translation>in MATLAB Vektoren und ihre Zeit von gleicher Länge sichern: save('readable.mat', 't', 'y')</translation>
    </message>
    <message>
        <source>the file cannot be opened</source>
        <translation>die Datei lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>Check its name and its access rights.</source>
        <translation>Ihren Namen und ihre Zugriffsrechte prüfen.</translation>
    </message>
    <message>
        <source>the file cannot be read</source>
        <translation>die Datei lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>files ending in '{}' cannot be read</source>
        <translation>Dateien mit der Endung „{}“ können nicht gelesen werden</translation>
    </message>
    <message>
        <source>Measurements are read from .csv, .txt, .tsv and .dat files: export the recording as comma-separated values.</source>
        <translation>Messungen werden aus .csv-, .txt-, .tsv- und .dat-Dateien gelesen: die Aufzeichnung als kommagetrennte Werte exportieren.</translation>
    </message>
    <message>
        <source>from t = {:.6g} s a relation of {} holds the model between its two sides (sliding)</source>
        <translation>ab t = {} s hält eine Relation von {} das Modell zwischen ihren beiden Seiten (Gleiten)</translation>
    </message>
    <message>
        <source>At the initial time: {}</source>
        <translation>Zum Anfangszeitpunkt: {}</translation>
    </message>
    <message>
        <source>The model is singular.</source>
        <translation>Das Modell ist singulär.</translation>
    </message>
    <message>
        <source> No equation determines {}.</source>
        <translation> Keine Gleichung bestimmt {}.</translation>
    </message>
    <message>
        <source> These equations have too few unknowns of their own: {}.</source>
        <translation> Diese Gleichungen haben zu wenige eigene Unbekannte: {}.</translation>
    </message>
    <message>
        <source> These equations repeat what others say: {}.</source>
        <translation> Diese Gleichungen wiederholen, was andere sagen: {}.</translation>
    </message>
    <message>
        <source>Look for a part that nothing holds (an open circuit, a loop without a fixed point), or for two sources that impose the same quantity.</source>
        <translation>Nach einem Teil suchen, den nichts hält (ein offener Kreis, eine Schleife ohne festen Punkt), oder nach zwei Quellen, die dieselbe Größe vorgeben.</translation>
    </message>
    <message>
        <source>the simulation of experiment &quot;{}&quot; stopped at t = {:.6g} s: {}{}</source>
        <translation>die Simulation von Versuch „{}“ blieb bei t = {} s stehen: {}{}</translation>
    </message>
    <message>
        <source>look at the values of the parameters near that variable</source>
        <translation>die Werte der Parameter in der Nähe dieser Variablen ansehen</translation>
    </message>
    <message>
        <source>there is no such file or directory</source>
        <translation>es gibt keine solche Datei und kein solches Verzeichnis</translation>
    </message>
    <message>
        <source>Give the directory of a study, or its study.json.</source>
        <translation>Das Verzeichnis einer Studie oder deren study.json angeben.</translation>
    </message>
    <message>
        <source>this directory holds no study.json</source>
        <translation>dieses Verzeichnis enthält keine study.json</translation>
    </message>
    <message>
        <source>A study is a directory with study.json, a model (.mo) and its measurements.</source>
        <translation>Eine Studie ist ein Verzeichnis mit study.json, einem Modell (.mo) und dessen Messungen.</translation>
    </message>
    <message>
        <source>packed studies cannot be read here</source>
        <translation>gepackte Studien können hier nicht gelesen werden</translation>
    </message>
    <message>
        <source>Unpack it (it is a zip archive) and give the directory.</source>
        <translation>Sie entpacken (es ist ein Zip-Archiv) und das Verzeichnis angeben.</translation>
    </message>
    <message>
        <source>this is not a study</source>
        <translation>dies ist keine Studie</translation>
    </message>
    <message>
        <source>The path is relative to the study's directory.</source>
        <translation>Der Pfad gilt ab dem Verzeichnis der Studie.</translation>
    </message>
    <message>
        <source>Did you mean '{}'?</source>
        <translation>Ist „{}“ gemeint?</translation>
    </message>
    <message>
        <source>experiment '{}': there is no file '{}'</source>
        <translation>Versuch „{}“: Es gibt keine Datei „{}“</translation>
    </message>
    <message>
        <source>experiment '{}': neither the study nor '{}' tells which column is the time</source>
        <translation>Experiment „{}“: weder die Studie noch „{}“ sagt, welche Spalte die Zeit ist</translation>
    </message>
    <message>
        <source>Name it: "time": "…".</source>
        <translation>Nennen Sie sie: "time": "…".</translation>
    </message>
    <message>
        <source>the measurement is neither on disk nor in the study</source>
        <translation>die Messung ist weder auf der Platte noch in der Studie</translation>
    </message>
    <message>
        <source>an object {{…}}</source>
        <translation>ein Objekt {{…}}</translation>
    </message>
    <message>
        <source>a list […]</source>
        <translation>eine Liste […]</translation>
    </message>
    <message>
        <source>the text &quot;{}&quot;</source>
        <translation>der Text &quot;{}&quot;</translation>
    </message>
    <message>
        <source>the number {}</source>
        <translation>die Zahl {}</translation>
    </message>
    <message>
        <source>an object {{…}} with the members of a study</source>
        <translation>ein Objekt {{…}} mit den Angaben einer Studie</translation>
    </message>
    <message>
        <source>{} is given twice</source>
        <translation>{} ist doppelt angegeben</translation>
    </message>
    <message>
        <source>Keep one of them.</source>
        <translation>Eines davon behalten.</translation>
    </message>
    <message>
        <source>a study</source>
        <translation>einer Studie</translation>
    </message>
    <message>
        <source>the study</source>
        <translation>die Studie</translation>
    </message>
    <message>
        <source>{}: expected {}, found {}</source>
        <translation>{}: erwartet: {}, gefunden: {}</translation>
    </message>
    <message>
        <source>{}: the member &quot;{}&quot; is missing</source>
        <translation>{}: Die Angabe &quot;{}&quot; fehlt</translation>
    </message>
    <message>
        <source>a text that is not empty</source>
        <translation>ein Text, der nicht leer ist</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is no member of {}; it is kept and has no effect</source>
        <translation>&quot;{}&quot; gehört nicht zu {}; es bleibt erhalten und bewirkt nichts</translation>
    </message>
    <message>
        <source>Did you mean &quot;{}&quot;?</source>
        <translation>Ist &quot;{}&quot; gemeint?</translation>
    </message>
    <message>
        <source>the format &quot;{}&quot; is not known</source>
        <translation>das Format &quot;{}&quot; ist nicht bekannt</translation>
    </message>
    <message>
        <source>a newer version of Analogon has written this study: its format is &quot;{}&quot;</source>
        <translation>eine neuere Version von Analogon hat diese Studie geschrieben: Ihr Format ist „{}“</translation>
    </message>
    <message>
        <source>This version reads &quot;{}&quot;: open the study with the newer one.</source>
        <translation>Diese Version liest „{}“: die Studie mit der neueren öffnen.</translation>
    </message>
    <message>
        <source>the study does not say its format; it is read as &quot;{}&quot;</source>
        <translation>die Studie nennt ihr Format nicht; sie wird als „{}“ gelesen</translation>
    </message>
    <message>
        <source>Saving it writes the format down.</source>
        <translation>Beim Speichern wird das Format eingetragen.</translation>
    </message>
    <message>
        <source>This program reads &quot;{}&quot;.</source>
        <translation>Dieses Programm liest &quot;{}&quot;.</translation>
    </message>
    <message>
        <source>a list […] of experiments</source>
        <translation>eine Liste […] von Versuchen</translation>
    </message>
    <message>
        <source>an experiment {{…}}</source>
        <translation>ein Versuch {{…}}</translation>
    </message>
    <message>
        <source>there are two experiments named '{}'</source>
        <translation>es gibt zwei Versuche namens „{}“</translation>
    </message>
    <message>
        <source>Give each experiment its own name.</source>
        <translation>Jedem Versuch einen eigenen Namen geben.</translation>
    </message>
    <message>
        <source>an experiment</source>
        <translation>einem Versuch</translation>
    </message>
    <message>
        <source>&quot;fit&quot; or &quot;validate&quot;</source>
        <translation>&quot;fit&quot; oder &quot;validate&quot;</translation>
    </message>
    <message>
        <source>start values {{parameter: value}}</source>
        <translation>Startwerte {{Parameter: Wert}}</translation>
    </message>
    <message>
        <source>two times [from, to] in seconds</source>
        <translation>zwei Zeiten [von, bis] in Sekunden</translation>
    </message>
    <message>
        <source>{}: the range ends at {} before it begins at {}</source>
        <translation>{}: Der Bereich endet bei {}, bevor er bei {} beginnt</translation>
    </message>
    <message>
        <source>an object {{model signal: column}}</source>
        <translation>ein Objekt {{Signal des Modells: Spalte}}</translation>
    </message>
    <message>
        <source>the name of a column, or {{&quot;column&quot;: …, &quot;unit&quot;: …}}</source>
        <translation>der Name einer Spalte, oder {{&quot;column&quot;: …, &quot;unit&quot;: …}}</translation>
    </message>
    <message>
        <source>{}: a scale of 0 wipes the column out</source>
        <translation>{}: Ein Faktor 0 löscht die Spalte</translation>
    </message>
    <message>
        <source>{}: a weight of {:.3g} is beyond what can be weighed ({:g} … {:g})</source>
        <translation>{}: Ein Gewicht von {} liegt jenseits dessen, was sich wägen lässt ({} … {})</translation>
    </message>
    <message>
        <source>A weight says how much an output counts beside the others, each in units of its range or its noise: 1 is the common one, 0 leaves it out.</source>
        <translation>Ein Gewicht sagt, wie viel ein Ausgang neben den anderen zählt, jeder in Einheiten seines Bereichs oder seines Rauschens: 1 ist üblich, 0 lässt ihn weg.</translation>
    </message>
    <message>
        <source>{}: a weight cannot be negative</source>
        <translation>{}: Ein Gewicht kann nicht negativ sein</translation>
    </message>
    <message>
        <source>{}: an output is compared where it was measured, never between its samples</source>
        <translation>{}: Ein Ausgang wird verglichen, wo er gemessen wurde, nie zwischen seinen Abtastwerten</translation>
    </message>
    <message>
        <source>Remove &quot;interpolation&quot; here; it belongs to an input.</source>
        <translation>„interpolation“ hier entfernen; es gehört zu einem Eingang.</translation>
    </message>
    <message>
        <source>&quot;linear&quot; or &quot;hold&quot;</source>
        <translation>&quot;linear&quot; oder &quot;hold&quot;</translation>
    </message>
    <message>
        <source>{}: expected &quot;linear&quot; or &quot;hold&quot;, found &quot;{}&quot;</source>
        <translation>{}: erwartet wird &quot;linear&quot; oder &quot;hold&quot;, gefunden wurde &quot;{}&quot;</translation>
    </message>
    <message>
        <source>&quot;linear&quot;: on straight lines between the samples; &quot;hold&quot;: each value until the next sample.</source>
        <translation>&quot;linear&quot;: auf Geraden zwischen den Abtastwerten; &quot;hold&quot;: jeder Wert bis zum nächsten Abtastwert.</translation>
    </message>
    <message>
        <source>a number of seconds, or &quot;fit&quot;</source>
        <translation>eine Zahl in Sekunden, oder &quot;fit&quot;</translation>
    </message>
    <message>
        <source>a mapped column</source>
        <translation>einer zugeordneten Spalte</translation>
    </message>
    <message>
        <source>a number, &quot;fit&quot; or the name of a column</source>
        <translation>eine Zahl, &quot;fit&quot; oder der Name einer Spalte</translation>
    </message>
    <message>
        <source>an object {{parameter: {{…}}}}</source>
        <translation>ein Objekt {{Parameter: {{…}}}}</translation>
    </message>
    <message>
        <source>an object, as {{&quot;fit&quot;: true, &quot;min&quot;: 0}}</source>
        <translation>ein Objekt, etwa {{&quot;fit&quot;: true, &quot;min&quot;: 0}}</translation>
    </message>
    <message>
        <source>a parameter</source>
        <translation>einem Parameter</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>&quot;lin&quot; or &quot;log&quot;</source>
        <translation>&quot;lin&quot; oder &quot;log&quot;</translation>
    </message>
    <message>
        <source>{}: the lower bound {} is not below the upper bound {}</source>
        <translation>{}: Die untere Grenze {} liegt nicht unter der oberen Grenze {}</translation>
    </message>
    <message>
        <source>{}: a logarithmic scale needs a lower bound above 0</source>
        <translation>{}: Eine logarithmische Skala braucht eine untere Grenze über 0</translation>
    </message>
    <message>
        <source>Raise &quot;min&quot;, or use &quot;scale&quot;: &quot;lin&quot;.</source>
        <translation>&quot;min&quot; erhöhen, oder &quot;scale&quot;: &quot;lin&quot; verwenden.</translation>
    </message>
    <message>
        <source>what is known, as {{&quot;mean&quot;: 3.2, &quot;std&quot;: 0.1}}</source>
        <translation>was bekannt ist, etwa {{&quot;mean&quot;: 3.2, &quot;std&quot;: 0.1}}</translation>
    </message>
    <message>
        <source>A prior is {{&quot;mean&quot;: …, &quot;std&quot;: …}}.</source>
        <translation>Vorwissen ist {{&quot;mean&quot;: …, &quot;std&quot;: …}}.</translation>
    </message>
    <message>
        <source>a prior</source>
        <translation>einem Vorwissen</translation>
    </message>
    <message>
        <source>{}: a standard deviation must be above 0</source>
        <translation>{}: Eine Standardabweichung muss über 0 liegen</translation>
    </message>
    <message>
        <source>A parameter that is known for sure is not fitted: &quot;fit&quot;: false.</source>
        <translation>Ein Parameter, der sicher bekannt ist, wird nicht angepasst: &quot;fit&quot;: false.</translation>
    </message>
    <message>
        <source>a list […] of paths</source>
        <translation>eine Liste […] von Pfaden</translation>
    </message>
    <message>
        <source>this is not valid JSON: {}</source>
        <translation>dies ist kein gültiges JSON: {}</translation>
    </message>
    <message>
        <source>this is not valid JSON: {} is no value</source>
        <translation>das ist kein gültiges JSON: {} ist kein Wert</translation>
    </message>
    <message>
        <source>A value is a number, a &quot;text&quot;, true, false, null, a list […] or an object {{…}}.</source>
        <translation>Ein Wert ist eine Zahl, ein &quot;Text&quot;, true, false, null, eine Liste […] oder ein Objekt {{…}}.</translation>
    </message>
    <message>
        <source>the number {} is too large</source>
        <translation>die Zahl {} ist zu groß</translation>
    </message>
    <message>
        <source>The largest that can be computed with is 1.8e308.</source>
        <translation>Die größte, mit der gerechnet werden kann, ist 1.8e308.</translation>
    </message>
    <message>
        <source>A comma, bracket or quotation mark is missing or one too many near here.</source>
        <translation>Hier in der Nähe fehlt ein Komma, eine Klammer oder ein Anführungszeichen, oder eines ist zu viel.</translation>
    </message>
    <message>
        <source>There is no column.</source>
        <translation>Es gibt keine Spalte.</translation>
    </message>
    <message>
        <source>Available: {}.</source>
        <translation>Vorhanden: {}.</translation>
    </message>
    <message>
        <source>the study has no experiment</source>
        <translation>die Studie hat keinen Versuch</translation>
    </message>
    <message>
        <source>Add a measurement to it.</source>
        <translation>Eine Messung hinzufügen.</translation>
    </message>
    <message>
        <source>the model '{}' has no parameter '{}'</source>
        <translation>das Modell „{}“ hat keinen Parameter „{}“</translation>
    </message>
    <message>
        <source>There is no parameter.</source>
        <translation>Es gibt keinen Parameter.</translation>
    </message>
    <message>
        <source>a variable</source>
        <translation>eine Variable</translation>
    </message>
    <message>
        <source>a constant</source>
        <translation>eine Konstante</translation>
    </message>
    <message>
        <source>an Integer that has shaped the equations, as the size of an array does</source>
        <translation>eine ganze Zahl, welche die Gleichungen geformt hat, wie die Größe eines Feldes es tut</translation>
    </message>
    <message>
        <source>an Integer</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>no real number</source>
        <translation>keine reelle Zahl</translation>
    </message>
    <message>
        <source>declared final</source>
        <translation>als final deklariert</translation>
    </message>
    <message>
        <source>computed by an initial equation</source>
        <translation>von einer Anfangsgleichung berechnet</translation>
    </message>
    <message>
        <source>'{}' is protected in the model; it is fitted all the same</source>
        <translation>„{}“ ist im Modell geschützt; angepasst wird es trotzdem</translation>
    </message>
    <message>
        <source>the model sets '{}' to {}; the fit gives it a value of its own</source>
        <translation>das Modell setzt „{}“ auf {}; die Anpassung gibt ihm einen eigenen Wert</translation>
    </message>
    <message>
        <source>protected</source>
        <translation>geschützt</translation>
    </message>
    <message>
        <source>'{}' cannot be set or fitted: it is {}</source>
        <translation>„{}“ lässt sich weder setzen noch anpassen: Es ist {}</translation>
    </message>
    <message>
        <source>Only real parameters that are neither final nor protected can.</source>
        <translation>Nur reelle Parameter, die weder final noch geschützt sind.</translation>
    </message>
    <message>
        <source>the parameter '{}' has no value to start from</source>
        <translation>der Parameter „{}“ hat keinen Wert, von dem aus zu beginnen wäre</translation>
    </message>
    <message>
        <source>Give one in the model, or as &quot;value&quot; in the study.</source>
        <translation>Einen im Modell angeben, oder als &quot;value&quot; in der Studie.</translation>
    </message>
    <message>
        <source>the start value {} of '{}' lies outside its bounds {} … {}</source>
        <translation>der Startwert {} von „{}“ liegt außerhalb der Grenzen {} … {}</translation>
    </message>
    <message>
        <source>'{}' has no room between its bounds {} and {}</source>
        <translation>„{}“ hat keinen Raum zwischen seinen Grenzen {} und {}</translation>
    </message>
    <message>
        <source>Widen the bounds, or do not fit it: &quot;fit&quot;: false.</source>
        <translation>Die Grenzen weiten, oder ihn nicht anpassen: &quot;fit&quot;: false.</translation>
    </message>
    <message>
        <source>the lower bound {} of '{}' lies below the min {} of its declaration, which holds</source>
        <translation>die untere Grenze {} von „{}“ liegt unter dem min {} seiner Deklaration, das gilt</translation>
    </message>
    <message>
        <source>the upper bound {} of '{}' lies above the max {} of its declaration, which holds</source>
        <translation>die obere Grenze {} von „{}“ liegt über dem max {} seiner Deklaration, das gilt</translation>
    </message>
    <message>
        <source>'{}' begins at {}, below its min {}</source>
        <translation>„{}“ beginnt bei {}, unter seinem min {}</translation>
    </message>
    <message>
        <source>'{}' begins at {}, above its max {}</source>
        <translation>„{}“ beginnt bei {}, über seinem max {}</translation>
    </message>
    <message>
        <source>change the value, or the range where the variable is declared</source>
        <translation>den Wert ändern, oder den Bereich, wo die Variable deklariert ist</translation>
    </message>
    <message>
        <source>a size or a condition that has shaped the equations</source>
        <translation>eine Größe oder Bedingung, nach der die Gleichungen gebildet sind</translation>
    </message>
    <message>
        <source>the model '{}' has no parameter and no variable '{}'</source>
        <translation>das Modell „{}“ hat keinen Parameter und keine Variable „{}“</translation>
    </message>
    <message>
        <source>Widen the bounds, or give another start as &quot;value&quot;.</source>
        <translation>Die Grenzen weiten, oder mit &quot;value&quot; einen anderen Start angeben.</translation>
    </message>
    <message>
        <source>'{}' starts at {}, where a logarithmic scale has no place</source>
        <translation>„{}“ beginnt bei {}, wo eine logarithmische Skala keinen Platz hat</translation>
    </message>
    <message>
        <source>Start above 0, or use &quot;scale&quot;: &quot;lin&quot;.</source>
        <translation>Über 0 beginnen, oder &quot;scale&quot;: &quot;lin&quot; verwenden.</translation>
    </message>
    <message>
        <source>no experiment asks for the clock of the output '{}'</source>
        <translation>kein Versuch fragt nach der Uhr des Ausgangs „{}“</translation>
    </message>
    <message>
        <source>Map the output as {{&quot;column&quot;: …, &quot;clock&quot;: &quot;fit&quot;}}.</source>
        <translation>Den Ausgang als {{&quot;column&quot;: …, &quot;clock&quot;: &quot;fit&quot;}} zuordnen.</translation>
    </message>
    <message>
        <source>experiment '{}': the clock of an input cannot be fitted</source>
        <translation>Versuch „{}“: Die Uhr eines Eingangs lässt sich nicht anpassen</translation>
    </message>
    <message>
        <source>Give its offset in seconds, or fit the clocks of the outputs.</source>
        <translation>Ihren Versatz in Sekunden angeben, oder die Uhren der Ausgänge anpassen.</translation>
    </message>
    <message>
        <source>the recording '{}' is left out: {}</source>
        <translation>Die Aufzeichnung „{}“ ist ausgelassen: {}</translation>
    </message>
    <message>
        <source>experiment '{}': the file '{}' has not been read</source>
        <translation>Versuch „{}“: Die Datei „{}“ wurde nicht gelesen</translation>
    </message>
    <message>
        <source>experiment '{}': '{}' has no column '{}'</source>
        <translation>Versuch „{}“: „{}“ hat keine Spalte „{}“</translation>
    </message>
    <message>
        <source>experiment '{}': fewer than two samples lie between {} s and {} s</source>
        <translation>Versuch „{}“: Zwischen {} s und {} s liegen weniger als zwei Abtastwerte</translation>
    </message>
    <message>
        <source>The file runs from {:.6g} s to {:.6g} s.</source>
        <translation>Die Datei läuft von {} s bis {} s.</translation>
    </message>
    <message>
        <source>There is no such signal.</source>
        <translation>Es gibt kein solches Signal.</translation>
    </message>
    <message>
        <source>It is an output of the model: list it under &quot;outputs&quot;.</source>
        <translation>Es ist ein Ausgang des Modells: unter &quot;outputs&quot; aufführen.</translation>
    </message>
    <message>
        <source>It is an input of the model: list it under &quot;inputs&quot;.</source>
        <translation>Es ist ein Eingang des Modells: unter &quot;inputs&quot; aufführen.</translation>
    </message>
    <message>
        <source>experiment '{}': the model '{}' has no input '{}'</source>
        <translation>Versuch „{}“: Das Modell „{}“ hat keinen Eingang „{}“</translation>
    </message>
    <message>
        <source>experiment '{}': the model '{}' has no output '{}'</source>
        <translation>Versuch „{}“: Das Modell „{}“ hat keinen Ausgang „{}“</translation>
    </message>
    <message>
        <source>experiment '{}': the input '{}' of the model has no column</source>
        <translation>Versuch „{}“: Der Eingang „{}“ des Modells hat keine Spalte</translation>
    </message>
    <message>
        <source>Add &quot;{}&quot;: &quot;COLUMN&quot; to &quot;inputs&quot;. {}</source>
        <translation>&quot;{}&quot;: &quot;SPALTE&quot; zu &quot;inputs&quot; hinzufügen. {}</translation>
    </message>
    <message>
        <source>experiment '{}' measures no output of the model</source>
        <translation>Versuch „{}“ misst keinen Ausgang des Modells</translation>
    </message>
    <message>
        <source>experiment '{}': the outputs '{}' and '{}' are both compared with the column '{}'</source>
        <translation>Versuch „{}“: die Ausgänge „{}“ und „{}“ werden beide mit der Spalte „{}“ verglichen</translation>
    </message>
    <message>
        <source>the input '{}' is held between its samples in '{}' and joined by straight lines in {}</source>
        <translation>der Eingang „{}“ wird in „{}“ zwischen seinen Abtastwerten gehalten und in {} durch Geraden verbunden</translation>
    </message>
    <message>
        <source>Give it &quot;interpolation&quot;: &quot;hold&quot; there, too, or say &quot;linear&quot; where it is meant.</source>
        <translation>Auch dort „interpolation“: „hold“ angeben, oder „linear“, wo es so gemeint ist.</translation>
    </message>
    <message>
        <source>nothing is compared: no output that is fitted has values and a weight above 0</source>
        <translation>nichts wird verglichen: kein Ausgang, der angepasst wird, hat Werte und ein Gewicht über 0</translation>
    </message>
    <message>
        <source>Give an output of an experiment that is fitted a &quot;weight&quot; above 0, or none.</source>
        <translation>Einem Ausgang eines Versuchs, der angepasst wird, ein &quot;weight&quot; über 0 geben, oder keines.</translation>
    </message>
    <message>
        <source>experiment '{}': '{}' is up to {:.3g} in size, too large to be fitted with</source>
        <translation>Experiment „{}“: „{}“ ist bis zu {:.3g} groß, zu groß für eine Anpassung</translation>
    </message>
    <message>
        <source>experiment '{}': '{}' is at most {:.3g} in size, too small to be fitted with</source>
        <translation>Experiment „{}“: „{}“ ist höchstens {:.3g} groß, zu klein für eine Anpassung</translation>
    </message>
    <message>
        <source>Look whether such values are marks for what was not measured, or in another unit than the study says; correct the column.</source>
        <translation>Nachsehen, ob solche Werte Zeichen für nicht Gemessenes sind oder in einer anderen Einheit stehen, als die Studie sagt; die Spalte berichtigen.</translation>
    </message>
    <message>
        <source>Look whether the column is in another unit than the study says; where such values stand for nothing, write 0.</source>
        <translation>Nachsehen, ob die Spalte in einer anderen Einheit steht, als die Studie sagt; wo solche Werte für nichts stehen, 0 schreiben.</translation>
    </message>
    <message>
        <source>there is nothing to fit: no parameter and no start value is to be found</source>
        <translation>es gibt nichts anzupassen: kein Parameter und kein Startwert ist gesucht</translation>
    </message>
    <message>
        <source>List parameters under &quot;parameters&quot;, as &quot;NAME&quot;: {{&quot;fit&quot;: true}}.</source>
        <translation>Parameter unter &quot;parameters&quot; nennen, als &quot;NAME&quot;: {{&quot;fit&quot;: true}}.</translation>
    </message>
    <message>
        <source>Map at least one of: {}.</source>
        <translation>Mindestens einen davon zuordnen: {}.</translation>
    </message>
    <message>
        <source>experiment '{}': the unit '{}' of '{}' is not known</source>
        <translation>Versuch „{}“: Die Einheit „{}“ von „{}“ ist nicht bekannt</translation>
    </message>
    <message>
        <source>Write the unit that the numbers of the column are in.</source>
        <translation>Die Einheit schreiben, in der die Zahlen der Spalte stehen.</translation>
    </message>
    <message>
        <source>where '{}' begins is told twice</source>
        <translation>wo „{}“ beginnt, ist zweimal angegeben</translation>
    </message>
    <message>
        <source>Keep one of the two entries.</source>
        <translation>Einen der beiden Einträge behalten.</translation>
    </message>
    <message>
        <source>'{}' has no value to start from</source>
        <translation>„{}“ hat keinen Wert, von dem aus zu beginnen wäre</translation>
    </message>
    <message>
        <source>Give one in the model.</source>
        <translation>Einen im Modell angeben.</translation>
    </message>
    <message>
        <source>the study has no model of '{}'</source>
        <translation>die Studie hat kein Modell von „{}“</translation>
    </message>
    <message>
        <source>Put the model's text beside study.json as model.mo.</source>
        <translation>Den Text des Modells als model.mo neben study.json legen.</translation>
    </message>
    <message>
        <source>there is no class '{}' in the models of the study</source>
        <translation>es gibt in den Modellen der Studie keine Klasse „{}“</translation>
    </message>
    <message>
        <source>There is no class.</source>
        <translation>Es gibt keine Klasse.</translation>
    </message>
    <message>
        <source>a delay of a delayed signal cannot be simulated</source>
        <translation>eine Totzeit eines verzögerten Signals kann nicht simuliert werden</translation>
    </message>
    <message>
        <source>an input is not finite</source>
        <translation>ein Eingang ist nicht endlich</translation>
    </message>
    <message>
        <source>directions do not have the shape the system asks for</source>
        <translation>die Richtungen haben nicht die Form, die das System verlangt</translation>
    </message>
    <message>
        <source>events faster than the steps</source>
        <translation>Ereignisse schneller als die Schritte</translation>
    </message>
    <message>
        <source>events without end</source>
        <translation>Ereignisse ohne Ende</translation>
    </message>
    <message>
        <source>inputs do not have the shape the system asks for</source>
        <translation>die Eingänge haben nicht die Form, die das System verlangt</translation>
    </message>
    <message>
        <source>more than 100000 events</source>
        <translation>mehr als 100000 Ereignisse</translation>
    </message>
    <message>
        <source>no convergence of an implicit step</source>
        <translation>keine Konvergenz eines impliziten Schritts</translation>
    </message>
    <message>
        <source>the model needs the slope of an input that is held</source>
        <translation>das Modell braucht die Steigung eines Eingangs, der gehalten wird</translation>
    </message>
    <message>
        <source>no convergence of an algebraic loop</source>
        <translation>keine Konvergenz einer algebraischen Schleife</translation>
    </message>
    <message>
        <source>no samples</source>
        <translation>keine Abtastwerte</translation>
    </message>
    <message>
        <source>not finite</source>
        <translation>nicht endlich</translation>
    </message>
    <message>
        <source>singular Jacobian</source>
        <translation>singuläre Jacobi-Matrix</translation>
    </message>
    <message>
        <source>step limit</source>
        <translation>Grenze der Schritte</translation>
    </message>
    <message>
        <source>the integrator could not be set up</source>
        <translation>der Integrator ließ sich nicht einrichten</translation>
    </message>
    <message>
        <source>the events do not go on</source>
        <translation>die Ereignisse gehen nicht weiter</translation>
    </message>
    <message>
        <source>the model ends the simulation</source>
        <translation>das Modell beendet die Simulation</translation>
    </message>
    <message>
        <source>'{}' changes at events alone, and begins with a value that is fitted</source>
        <translation>„{}“ ändert sich nur bei Ereignissen und beginnt mit einem Wert, der angepasst wird</translation>
    </message>
    <message>
        <source>fit what does not decide how it begins</source>
        <translation>passen Sie an, was nicht bestimmt, wie es beginnt</translation>
    </message>
    <message>
        <source>the integrator could not restart</source>
        <translation>der Integrator ließ sich nicht neu starten</translation>
    </message>
    <message>
        <source>the step became too small for the tolerance</source>
        <translation>der Schritt wurde für die Toleranz zu klein</translation>
    </message>
    <message>
        <source>the tolerance is beyond the machine's accuracy</source>
        <translation>die Toleranz übersteigt die Genauigkeit der Maschine</translation>
    </message>
    <message>
        <source>time limit</source>
        <translation>Zeitgrenze</translation>
    </message>
    <message>
        <source>wrong number of parameters</source>
        <translation>falsche Zahl von Parametern</translation>
    </message>
    <message>
        <source>cannot be found</source>
        <translation>ist nicht zu finden</translation>
    </message>
    <message>
        <source>cannot be read: its header is damaged</source>
        <translation>kann nicht gelesen werden: Sein Kopf ist beschädigt</translation>
    </message>
    <message>
        <source>is damaged: its compressed data cannot be read</source>
        <translation>ist beschädigt: Seine gepackten Daten können nicht gelesen werden</translation>
    </message>
    <message>
        <source>is larger than the archive says</source>
        <translation>ist größer, als das Archiv sagt</translation>
    </message>
    <message>
        <source>is shorter than the archive says</source>
        <translation>ist kürzer, als das Archiv sagt</translation>
    </message>
    <message>
        <source>is damaged: its checksum does not fit</source>
        <translation>ist beschädigt: Seine Prüfsumme stimmt nicht</translation>
    </message>
    <message>
        <source>the connector {} has {} flow and 1 potential variable</source>
        <translation>der Anschluss {} hat {} Fluss- und 1 Potentialvariable</translation>
    </message>
    <message>
        <source>the connector {} has {} flow and {} potential variables</source>
        <translation>der Anschluss {} hat {} Fluss- und {} Potentialvariablen</translation>
    </message>
    <message>
        <source>a connector needs as many flow variables as others</source>
        <translation>ein Anschluss braucht ebenso viele Flussvariablen wie andere</translation>
    </message>
    <message>
        <source>1 equation</source>
        <translation>1 Gleichung</translation>
    </message>
    <message>
        <source>{} equations</source>
        <translation>{} Gleichungen</translation>
    </message>
    <message>
        <source>1 unknown</source>
        <translation>1 Unbekannte</translation>
    </message>
    <message>
        <source>{} unknowns</source>
        <translation>{} Unbekannte</translation>
    </message>
    <message>
        <source>remove an equation or a value, or add a variable</source>
        <translation>eine Gleichung oder einen Wert entfernen, oder eine Variable hinzufügen</translation>
    </message>
    <message>
        <source>add an equation, or connect what is open</source>
        <translation>eine Gleichung hinzufügen, oder verbinden, was offen ist</translation>
    </message>
    <message>
        <source>no equation holds the output {}</source>
        <translation>in keiner Gleichung steht der Ausgang {}</translation>
    </message>
    <message>
        <source>no equation holds {}</source>
        <translation>in keiner Gleichung steht {}</translation>
    </message>
    <message>
        <source>{} has {} for {}: {} too many</source>
        <translation>{} hat {} für {}: {} zu viel</translation>
    </message>
    <message>
        <source>{} has {} for {}: {} too few</source>
        <translation>{} hat {} für {}: {} zu wenig</translation>
    </message>
    <message>
        <source>model '{}' has {} equations for {} unknowns</source>
        <translation>Modell „{}“ hat {} Gleichungen für {} Unbekannte</translation>
    </message>
    <message>
        <source>connect: the sizes differ, {}{} and {}{}</source>
        <translation>connect: die Größen unterscheiden sich, {}{} und {}{}</translation>
    </message>
    <message>
        <source>connect: '{}' is {}, not a connector</source>
        <translation>connect: „{}“ ist {}, kein Anschluss</translation>
    </message>
    <message>
        <source>a {} variable</source>
        <translation>eine Variable vom Typ {}</translation>
    </message>
    <message>
        <source>a component of class {}</source>
        <translation>ein Bauteil der Klasse {}</translation>
    </message>
    <message>
        <source>name one of its connectors</source>
        <translation>einen seiner Anschlüsse nennen</translation>
    </message>
    <message>
        <source>connect: '{}' lies inside a component</source>
        <translation>connect: „{}“ liegt innerhalb eines Bauteils</translation>
    </message>
    <message>
        <source>connect to a connector of the component itself</source>
        <translation>mit einem Anschluss des Bauteils selbst verbinden</translation>
    </message>
    <message>
        <source>is a signal</source>
        <translation>ist ein Signal</translation>
    </message>
    <message>
        <source>has {}</source>
        <translation>hat {}</translation>
    </message>
    <message>
        <source>{}: the connectors do not fit: '{}' ({}) {}, '{}' ({}) {}</source>
        <translation>{}: die Anschlüsse passen nicht: „{}“ ({}) {}, „{}“ ({}) {}</translation>
    </message>
    <message>
        <source>connect connectors of the same kind</source>
        <translation>Anschlüsse derselben Art verbinden</translation>
    </message>
    <message>
        <source>{}: '{}' is {}, '{}' is {}</source>
        <translation>{}: „{}“ ist {}, „{}“ ist {}</translation>
    </message>
    <message>
        <source>{}: the units differ: '{}' is in {}, '{}' in {}</source>
        <translation>{}: die Einheiten unterscheiden sich: „{}“ ist in {}, „{}“ in {}</translation>
    </message>
    <message>
        <source>check which variables are meant to be connected</source>
        <translation>prüfen, welche Variablen verbunden werden sollen</translation>
    </message>
    <message>
        <source>two signals drive each other: {} and {} are both sources</source>
        <translation>zwei Signale treiben einander: {} und {} sind beide Quellen</translation>
    </message>
    <message>
        <source>connect an output to inputs only</source>
        <translation>einen Ausgang nur mit Eingängen verbinden</translation>
    </message>
    <message>
        <source>the input {} is connected to inputs only</source>
        <translation>der Eingang {} ist nur mit Eingängen verbunden</translation>
    </message>
    <message>
        <source>connect one of them to an output</source>
        <translation>einen davon mit einem Ausgang verbinden</translation>
    </message>
    <message>
        <source>the input '{}' is connected and has a value as well</source>
        <translation>der Eingang „{}“ ist verbunden und hat außerdem einen Wert</translation>
    </message>
    <message>
        <source>remove the connection or the value</source>
        <translation>die Verbindung oder den Wert entfernen</translation>
    </message>
    <message>
        <source>the input '{}' of {} is not connected</source>
        <translation>der Eingang „{}“ von {} ist nicht verbunden</translation>
    </message>
    <message>
        <source>the input '{}' of {} has no value</source>
        <translation>der Eingang „{}“ von {} hat keinen Wert</translation>
    </message>
    <message>
        <source>connect it to an output or a top-level input</source>
        <translation>ihn mit einem Ausgang oder einem Eingang des Modells verbinden</translation>
    </message>
    <message>
        <source>give it one where the component is declared: {}({} = …); an equation can only set an input that is a connector, such as RealInput</source>
        <translation>ihm einen geben, wo das Bauteil deklariert ist: {}({} = …); eine Gleichung kann nur einen Eingang setzen, der ein Anschluss ist, wie RealInput</translation>
    </message>
    <message>
        <source>the class '{}' is not known</source>
        <translation>die Klasse „{}“ ist nicht bekannt</translation>
    </message>
    <message>
        <source>model '{}'</source>
        <translation>Modell „{}“</translation>
    </message>
    <message>
        <source>component '{}' ({})</source>
        <translation>Bauteil „{}“ ({})</translation>
    </message>
    <message>
        <source>'{}' belongs to the Modelica Standard Library, which was not found</source>
        <translation>„{}“ gehört zur Modelica Standard Library, die nicht gefunden wurde</translation>
    </message>
    <message>
        <source>name the directory that holds it in MODELICAPATH or with --library</source>
        <translation>das Verzeichnis, in dem sie liegt, in MODELICAPATH oder mit --library nennen</translation>
    </message>
    <message>
        <source>name the directory that holds it in MODELICAPATH or with --library; the nearest of Analogon's own classes is {}</source>
        <translation>das Verzeichnis, in dem sie liegt, in MODELICAPATH oder mit --library nennen; die nächste eigene Klasse von Analogon ist {}</translation>
    </message>
    <message>
        <source>'{}' is called '{}' in the library that was found</source>
        <translation>„{}“ heißt in der gefundenen Bibliothek „{}“</translation>
    </message>
    <message>
        <source>the newer name is taken; write it to be independent of the version</source>
        <translation>der neuere Name wird genommen; ihn schreiben, um nicht von der Version abzuhängen</translation>
    </message>
    <message>
        <source>did you mean '{}'?</source>
        <translation>ist „{}“ gemeint?</translation>
    </message>
    <message>
        <source>'{}' is not declared in {}</source>
        <translation>„{}“ ist in {} nicht deklariert</translation>
    </message>
    <message>
        <source>'{}' is a variable and has no member '{}'</source>
        <translation>„{}“ ist eine Variable und hat keinen Bestandteil „{}“</translation>
    </message>
    <message>
        <source>{} has no member '{}'</source>
        <translation>{} hat keinen Bestandteil „{}“</translation>
    </message>
    <message>
        <source>'{}' of {} is protected</source>
        <translation>„{}“ von {} ist geschützt</translation>
    </message>
    <message>
        <source>use a public variable, or make it public where it is declared</source>
        <translation>eine öffentliche Variable verwenden, oder sie dort öffentlich machen, wo sie deklariert ist</translation>
    </message>
    <message>
        <source>'{}' could not be instantiated</source>
        <translation>„{}“ ließ sich nicht instanziieren</translation>
    </message>
    <message>
        <source>'{}' is switched off by its condition</source>
        <translation>„{}“ ist durch seine Bedingung abgeschaltet</translation>
    </message>
    <message>
        <source>a conditional component may be used in connect equations only</source>
        <translation>ein bedingtes Bauteil darf nur in connect-Gleichungen verwendet werden</translation>
    </message>
    <message>
        <source>'{}' is a member of an empty array</source>
        <translation>„{}“ ist Bestandteil eines leeren Felds</translation>
    </message>
    <message>
        <source>'{}' has {} subscripts for {} dimensions</source>
        <translation>„{}“ hat {} Indizes für {} Dimensionen</translation>
    </message>
    <message>
        <source>a subscript must be an Integer, not {}</source>
        <translation>ein Index muss Integer sein, nicht {}</translation>
    </message>
    <message>
        <source>a subscript must be an Integer that is known before the simulation</source>
        <translation>ein Index muss ein Integer sein, der vor der Simulation bekannt ist</translation>
    </message>
    <message>
        <source>use a number, an iterator of a for loop or a parameter</source>
        <translation>eine Zahl, die Variable einer for-Schleife oder einen Parameter verwenden</translation>
    </message>
    <message>
        <source>the subscript {} is outside 1:{}</source>
        <translation>der Index {} liegt außerhalb von 1:{}</translation>
    </message>
    <message>
        <source>'{}' is a component of class {}, not a value</source>
        <translation>„{}“ ist ein Bauteil der Klasse {}, kein Wert</translation>
    </message>
    <message>
        <source>name one of its variables</source>
        <translation>eine seiner Variablen nennen</translation>
    </message>
    <message>
        <source>'{}' is not a value of the enumeration {}</source>
        <translation>„{}“ ist kein Wert der Aufzählung {}</translation>
    </message>
    <message>
        <source>'{}' has no constant '{}'</source>
        <translation>„{}“ hat keine Konstante „{}“</translation>
    </message>
    <message>
        <source>the constant '{}.{}' has no value</source>
        <translation>die Konstante „{}.{}“ hat keinen Wert</translation>
    </message>
    <message>
        <source>the constant '{}.{}' depends on itself</source>
        <translation>die Konstante „{}.{}“ hängt von sich selbst ab</translation>
    </message>
    <message>
        <source>{} of different units: '{}' is in {}, '{}' in {}</source>
        <translation>{} verschiedener Einheiten: „{}“ ist in {}, „{}“ in {}</translation>
    </message>
    <message>
        <source>{} of a quantity with a unit: '{}' is in {}</source>
        <translation>{} einer Größe mit Einheit: „{}“ ist in {}</translation>
    </message>
    <message>
        <source>check the equation, or the units of what stands in it</source>
        <translation>die Gleichung prüfen, oder die Einheiten dessen, was darin steht</translation>
    </message>
    <message>
        <source>the units of both sides differ: '{}' is in {}, '{}' in {}</source>
        <translation>die Einheiten beider Seiten unterscheiden sich: „{}“ ist in {}, „{}“ in {}</translation>
    </message>
    <message>
        <source>'{}' is in {}, its value '{}' in {}</source>
        <translation>„{}“ ist in {}, sein Wert „{}“ in {}</translation>
    </message>
    <message>
        <source>check the value, or the unit of one of them</source>
        <translation>den Wert prüfen, oder die Einheit eines der beiden</translation>
    </message>
    <message>
        <source>a sum</source>
        <translation>eine Summe</translation>
    </message>
    <message>
        <source>a difference</source>
        <translation>eine Differenz</translation>
    </message>
    <message>
        <source>a minimum</source>
        <translation>ein Minimum</translation>
    </message>
    <message>
        <source>a maximum</source>
        <translation>ein Maximum</translation>
    </message>
    <message>
        <source>branches</source>
        <translation>Zweige</translation>
    </message>
    <message>
        <source>a comparison</source>
        <translation>ein Vergleich</translation>
    </message>
    <message>
        <source>the value of '{}' depends on itself</source>
        <translation>der Wert von „{}“ hängt von sich selbst ab</translation>
    </message>
    <message>
        <source>break the circle of parameters</source>
        <translation>den Kreis der Parameter aufbrechen</translation>
    </message>
    <message>
        <source>write 'each' before the attribute, or fill(value, size)</source>
        <translation>„each“ vor das Attribut schreiben, oder fill(Wert, Größe)</translation>
    </message>
    <message>
        <source>{} of '{}' has size {}, the variable {}</source>
        <translation>{} von „{}“ hat die Größe {}, die Variable {}</translation>
    </message>
    <message>
        <source>of a single value</source>
        <translation>eines einzelnen Werts</translation>
    </message>
    <message>
        <source>is a single value</source>
        <translation>ist ein einzelner Wert</translation>
    </message>
    <message>
        <source>'{}' is not an attribute of {}</source>
        <translation>„{}“ ist kein Attribut von {}</translation>
    </message>
    <message>
        <source>the attribute '{}'</source>
        <translation>das Attribut „{}“</translation>
    </message>
    <message>
        <source>the attribute '{}' of '{}' cannot be {}</source>
        <translation>das Attribut „{}“ von „{}“ kann nicht {} sein</translation>
    </message>
    <message>
        <source>the start value of '{}' changes while the model runs</source>
        <translation>der Startwert von „{}“ ändert sich, während das Modell läuft</translation>
    </message>
    <message>
        <source>use numbers and parameters</source>
        <translation>Zahlen und Parameter verwenden</translation>
    </message>
    <message>
        <source>the attribute '{}' must be known before the simulation</source>
        <translation>das Attribut „{}“ muss vor der Simulation bekannt sein</translation>
    </message>
    <message>
        <source>'stateSelect' is one of StateSelect.never, avoid, default, prefer, always</source>
        <translation>„stateSelect“ ist eines von StateSelect.never, avoid, default, prefer, always</translation>
    </message>
    <message>
        <source>the value</source>
        <translation>der Wert</translation>
    </message>
    <message>
        <source>'{}' is {} and cannot be {}</source>
        <translation>„{}“ ist {} und kann nicht {} sein</translation>
    </message>
    <message>
        <source>the constant '{}' has no value</source>
        <translation>die Konstante „{}“ hat keinen Wert</translation>
    </message>
    <message>
        <source>the parameter '{}' has no value</source>
        <translation>der Parameter „{}“ hat keinen Wert</translation>
    </message>
    <message>
        <source>give it one, for example {} = 1</source>
        <translation>einen angeben, zum Beispiel {} = 1</translation>
    </message>
    <message>
        <source>the parameter '{}' depends on {}, which changes while the model runs</source>
        <translation>der Parameter „{}“ hängt von {} ab, das sich ändert, während das Modell läuft</translation>
    </message>
    <message>
        <source>remove the prefix 'parameter', or use parameters only</source>
        <translation>den Vorsatz „parameter“ entfernen, oder nur Parameter verwenden</translation>
    </message>
    <message>
        <source>parameters depend on each other: {} -&gt; {}</source>
        <translation>Parameter hängen voneinander ab: {} -&gt; {}</translation>
    </message>
    <message>
        <source>give one of them a value of its own</source>
        <translation>einem davon einen eigenen Wert geben</translation>
    </message>
    <message>
        <source>the parameter '{}' is {}, below its min {}</source>
        <translation>der Parameter „{}“ ist {}, unter seinem min {}</translation>
    </message>
    <message>
        <source>the parameter '{}' is {}, above its max {}</source>
        <translation>der Parameter „{}“ ist {}, über seinem max {}</translation>
    </message>
    <message>
        <source>change the value, or the range where the parameter is declared</source>
        <translation>den Wert ändern, oder den Bereich, wo der Parameter deklariert ist</translation>
    </message>
    <message>
        <source>'connect' cannot stand in an initial equation section</source>
        <translation>„connect“ kann nicht in einem Abschnitt initial equation stehen</translation>
    </message>
    <message>
        <source>'connect' needs a condition that is known before the simulation</source>
        <translation>„connect“ braucht eine Bedingung, die vor der Simulation bekannt ist</translation>
    </message>
    <message>
        <source>the sides of the equation differ in type: {} and {}</source>
        <translation>die Seiten der Gleichung sind von verschiedener Art: {} und {}</translation>
    </message>
    <message>
        <source>the sides of the equation differ in size: {} and {}</source>
        <translation>die Seiten der Gleichung sind von verschiedener Größe: {} und {}</translation>
    </message>
    <message>
        <source>'{}' has the size {} and '{}' the size {}; they are no array together</source>
        <translation>„{}“ hat die Größe {} und „{}“ die Größe {}; zusammen sind sie kein Feld</translation>
    </message>
    <message>
        <source>name one of the components by its subscript</source>
        <translation>eine der Komponenten mit ihrem Index nennen</translation>
    </message>
    <message>
        <source>the model has more than {} equations</source>
        <translation>das Modell hat mehr als {} Gleichungen</translation>
    </message>
    <message>
        <source>the condition after 'if' must be Boolean, not {}</source>
        <translation>die Bedingung nach „if“ muss Boolean sein, nicht {}</translation>
    </message>
    <message>
        <source>an 'if' on a condition that changes needs as many equations in each branch</source>
        <translation>ein „if“ mit einer Bedingung, die sich ändert, braucht in jedem Zweig gleich viele Gleichungen</translation>
    </message>
    <message>
        <source>add the missing branch, or use a parameter in the condition</source>
        <translation>den fehlenden Zweig hinzufügen, oder in der Bedingung einen Parameter verwenden</translation>
    </message>
    <message>
        <source>the loops run through more than {} values</source>
        <translation>die Schleifen durchlaufen mehr als {} Werte</translation>
    </message>
    <message>
        <source>'{}' cannot stand as an equation</source>
        <translation>„{}“ kann nicht als Gleichung stehen</translation>
    </message>
    <message>
        <source>write: left = right</source>
        <translation>schreiben: links = rechts</translation>
    </message>
    <message>
        <source>'assert' needs a Boolean condition and a text</source>
        <translation>„assert“ braucht eine Bedingung vom Typ Boolean und einen Text</translation>
    </message>
    <message>
        <source>the assertion is not checked: its condition changes while the model runs</source>
        <translation>die Zusicherung wird nicht geprüft: Ihre Bedingung ändert sich, während das Modell läuft</translation>
    </message>
    <message>
        <source>{}: {}</source>
        <translation>{}: {}</translation>
    </message>
    <message>
        <source>the condition of 'assert' does not hold</source>
        <translation>die Bedingung von „assert“ gilt nicht</translation>
    </message>
    <message>
        <source>its parameters are {}</source>
        <translation>seine Parameter sind {}</translation>
    </message>
    <message>
        <source>'{}' has components or equations and cannot extend {}</source>
        <translation>„{}“ hat Bauteile oder Gleichungen und kann {} nicht erweitern</translation>
    </message>
    <message>
        <source>the base class '{}' of '{}' is not known</source>
        <translation>die Basisklasse „{}“ von „{}“ ist nicht bekannt</translation>
    </message>
    <message>
        <source>'{}' is a {} and cannot extend {}, which is a {}</source>
        <translation>„{}“ ist ein {} und kann {} nicht erweitern, das ein {} ist</translation>
    </message>
    <message>
        <source>'{}' extends itself: {} extends {}</source>
        <translation>„{}“ erweitert sich selbst: {} erweitert {}</translation>
    </message>
    <message>
        <source>remove one of the extends clauses</source>
        <translation>eine der extends-Anweisungen entfernen</translation>
    </message>
    <message>
        <source>'{}' inherits through more than {} classes</source>
        <translation>„{}“ erbt über mehr als {} Klassen</translation>
    </message>
    <message>
        <source>'{}' inherits too many classes</source>
        <translation>„{}“ erbt von zu vielen Klassen</translation>
    </message>
    <message>
        <source>'{}' redeclares '{}', which it does not inherit</source>
        <translation>„{}“ deklariert „{}“ neu, erbt es aber nicht</translation>
    </message>
    <message>
        <source>'{}' of '{}' is not replaceable</source>
        <translation>„{}“ von „{}“ ist nicht ersetzbar</translation>
    </message>
    <message>
        <source>declare it 'replaceable' or modify it without 'redeclare'</source>
        <translation>es als „replaceable“ deklarieren, oder ohne „redeclare“ modifizieren</translation>
    </message>
    <message>
        <source>'{}' is declared twice in '{}'</source>
        <translation>„{}“ ist in „{}“ zweimal deklariert</translation>
    </message>
    <message>
        <source>rename or remove one of the two declarations</source>
        <translation>eine der beiden Deklarationen umbenennen oder entfernen</translation>
    </message>
    <message>
        <source>'{}' is declared in '{}' and, differently, in '{}'</source>
        <translation>„{}“ ist in „{}“ deklariert und, anders, in „{}“</translation>
    </message>
    <message>
        <source>rename it, or declare it 'redeclare'</source>
        <translation>es umbenennen, oder als „redeclare“ deklarieren</translation>
    </message>
    <message>
        <source>'{}' of '{}' is a component, not a class</source>
        <translation>„{}“ von „{}“ ist ein Bauteil, keine Klasse</translation>
    </message>
    <message>
        <source>redeclare it as a component: redeclare TYPE NAME</source>
        <translation>es als Bauteil neu deklarieren: redeclare TYP NAME</translation>
    </message>
    <message>
        <source>'{}' of '{}' is protected and cannot be modified</source>
        <translation>„{}“ von „{}“ ist geschützt und kann nicht modifiziert werden</translation>
    </message>
    <message>
        <source>'{}' of '{}' is a class; it can only be redeclared</source>
        <translation>„{}“ von „{}“ ist eine Klasse; sie kann nur neu deklariert werden</translation>
    </message>
    <message>
        <source>the class '{}' of '{}' is not replaceable</source>
        <translation>die Klasse „{}“ von „{}“ ist nicht ersetzbar</translation>
    </message>
    <message>
        <source>'{}' has no element '{}' to modify</source>
        <translation>„{}“ hat kein Element „{}“, das zu modifizieren wäre</translation>
    </message>
    <message>
        <source>'{}' is a {}, not a model</source>
        <translation>„{}“ ist ein {}, kein Modell</translation>
    </message>
    <message>
        <source>choose a model or block</source>
        <translation>ein Modell oder einen Block wählen</translation>
    </message>
    <message>
        <source>'{}' is partial and cannot be used as it stands</source>
        <translation>„{}“ ist partial und kann so nicht verwendet werden</translation>
    </message>
    <message>
        <source>use a model that extends it</source>
        <translation>ein Modell verwenden, das es erweitert</translation>
    </message>
    <message>
        <source>the size or condition of '{}' depends on itself</source>
        <translation>die Größe oder Bedingung von „{}“ hängt von sich selbst ab</translation>
    </message>
    <message>
        <source>'{}' of '{}' is not supported</source>
        <translation>„{}“ von „{}“ wird nicht unterstützt</translation>
    </message>
    <message>
        <source>pass the value as a parameter or connect it</source>
        <translation>den Wert als Parameter übergeben oder verbinden</translation>
    </message>
    <message>
        <source>the condition of '{}'</source>
        <translation>die Bedingung von „{}“</translation>
    </message>
    <message>
        <source>'{}' is declared as input and as output</source>
        <translation>„{}“ ist als Eingang und als Ausgang deklariert</translation>
    </message>
    <message>
        <source>the size of '{}'</source>
        <translation>die Größe von „{}“</translation>
    </message>
    <message>
        <source>the size of '{}' is negative ({})</source>
        <translation>die Größe von „{}“ ist negativ ({})</translation>
    </message>
    <message>
        <source>'{}' has an open size and no value that would give it</source>
        <translation>„{}“ hat eine offene Größe und keinen Wert, der sie angäbe</translation>
    </message>
    <message>
        <source>write the size or a value</source>
        <translation>die Größe oder einen Wert hinschreiben</translation>
    </message>
    <message>
        <source>the value of '{}' has {} dimensions, its declaration more</source>
        <translation>der Wert von „{}“ hat {} Dimensionen, seine Deklaration mehr</translation>
    </message>
    <message>
        <source>'{}{}' makes the model larger than {} scalars</source>
        <translation>„{}{}“ macht das Modell größer als {} Skalare</translation>
    </message>
    <message>
        <source>'{}{}' makes the model larger than {} components</source>
        <translation>„{}{}“ macht das Modell größer als {} Bauteile</translation>
    </message>
    <message>
        <source>use a smaller size</source>
        <translation>eine kleinere Größe verwenden</translation>
    </message>
    <message>
        <source>'{}' contains itself: {} has {}</source>
        <translation>„{}“ enthält sich selbst: {} hat {}</translation>
    </message>
    <message>
        <source>break the circle of components</source>
        <translation>den Kreis der Bauteile aufbrechen</translation>
    </message>
    <message>
        <source>components are nested more than {} deep at '{}'</source>
        <translation>Bauteile sind bei „{1}“ tiefer als {0} verschachtelt</translation>
    </message>
    <message>
        <source>'{}' cannot be a component: {} is a {}</source>
        <translation>„{}“ kann kein Bauteil sein: {} ist ein {}</translation>
    </message>
    <message>
        <source>'{}' is of the partial class {}</source>
        <translation>„{}“ ist von der partiellen Klasse {}</translation>
    </message>
    <message>
        <source>use a class that extends it, or redeclare the component</source>
        <translation>eine Klasse verwenden, die sie erweitert, oder das Bauteil neu deklarieren</translation>
    </message>
    <message>
        <source>'{}' is a {}; it has no value that could be set with '='</source>
        <translation>„{}“ ist ein {}; es hat keinen Wert, der mit „=“ zu setzen wäre</translation>
    </message>
    <message>
        <source>modify its parameters: name(parameter = value)</source>
        <translation>seine Parameter modifizieren: name(parameter = wert)</translation>
    </message>
    <message>
        <source>'{}' is modified twice</source>
        <translation>„{}“ wird zweimal modifiziert</translation>
    </message>
    <message>
        <source>keep one of the two modifications</source>
        <translation>eine der beiden Modifikationen behalten</translation>
    </message>
    <message>
        <source>'{}' is final and cannot be modified</source>
        <translation>„{}“ ist final und kann nicht modifiziert werden</translation>
    </message>
    <message>
        <source>remove the modification; the value is fixed where the element is declared</source>
        <translation>die Modifikation entfernen; der Wert liegt dort fest, wo das Element deklariert ist</translation>
    </message>
    <message>
        <source>the model</source>
        <translation>das Modell</translation>
    </message>
    <message>
        <source>the expression is nested too deeply</source>
        <translation>der Ausdruck ist zu tief verschachtelt</translation>
    </message>
    <message>
        <source>split it with variables</source>
        <translation>ihn mit Variablen aufteilen</translation>
    </message>
    <message>
        <source>a list in parentheses is not a value here</source>
        <translation>eine Liste in Klammern ist hier kein Wert</translation>
    </message>
    <message>
        <source>write one equation for each member</source>
        <translation>für jeden Teil eine Gleichung schreiben</translation>
    </message>
    <message>
        <source>'{}' has a meaning in a subscript only</source>
        <translation>„{}“ hat nur in einem Index eine Bedeutung</translation>
    </message>
    <message>
        <source>a record can be set to another record only</source>
        <translation>ein record kann nur einem anderen record gleichgesetzt werden</translation>
    </message>
    <message>
        <source>a single value is given to an array of components</source>
        <translation>einem Feld von Bauteilen wird ein einzelner Wert gegeben</translation>
    </message>
    <message>
        <source>write 'each' before the name, or one value per element: {{a, b, …}}</source>
        <translation>„each“ vor den Namen schreiben, oder für jedes Element einen Wert: {{a, b, …}}</translation>
    </message>
    <message>
        <source>the value has size {}, the array of components is larger</source>
        <translation>der Wert hat die Größe {}, das Feld der Bauteile ist größer</translation>
    </message>
    <message>
        <source>the arrays of the model are too large to be worked out</source>
        <translation>die Felder des Modells sind zu groß, um ausgearbeitet zu werden</translation>
    </message>
    <message>
        <source>use smaller sizes</source>
        <translation>kleinere Größen verwenden</translation>
    </message>
    <message>
        <source>'{}' needs a Boolean value, not {}</source>
        <translation>„{}“ braucht einen Wert vom Typ Boolean, nicht {}</translation>
    </message>
    <message>
        <source>'{}' needs a numeric value, not {}</source>
        <translation>„{}“ braucht eine Zahl, nicht {}</translation>
    </message>
    <message>
        <source>the branches of 'if' differ in type: {} and {}</source>
        <translation>die Zweige von „if“ sind von verschiedener Art: {} und {}</translation>
    </message>
    <message>
        <source>a text cannot change while the model runs</source>
        <translation>ein Text kann sich nicht ändern, während das Modell läuft</translation>
    </message>
    <message>
        <source>the iterator '{}' needs a range</source>
        <translation>die Laufvariable „{}“ braucht einen Bereich</translation>
    </message>
    <message>
        <source>write: for i in 1:n</source>
        <translation>schreiben: for i in 1:n</translation>
    </message>
    <message>
        <source>the elements of an array must be alike: {} and {}</source>
        <translation>die Elemente eines Felds müssen gleichartig sein: {} und {}</translation>
    </message>
    <message>
        <source>a range is expected, not {}</source>
        <translation>erwartet wird ein Bereich, nicht {}</translation>
    </message>
    <message>
        <source>write: first:last</source>
        <translation>schreiben: erster:letzter</translation>
    </message>
    <message>
        <source>the limits of a range must be numbers that are known before the simulation</source>
        <translation>die Grenzen eines Bereichs müssen Zahlen sein, die vor der Simulation bekannt sind</translation>
    </message>
    <message>
        <source>use a parameter or a constant</source>
        <translation>einen Parameter oder eine Konstante verwenden</translation>
    </message>
    <message>
        <source>the range has more than {} values</source>
        <translation>der Bereich hat mehr als {} Werte</translation>
    </message>
    <message>
        <source>{} must be known before the simulation</source>
        <translation>{} muss vor der Simulation bekannt sein</translation>
    </message>
    <message>
        <source>use a number, a parameter with a value or a constant</source>
        <translation>eine Zahl, einen Parameter mit Wert oder eine Konstante verwenden</translation>
    </message>
    <message>
        <source>{} must be an Integer, not {}</source>
        <translation>{} muss Integer sein, nicht {}</translation>
    </message>
    <message>
        <source>use a parameter with a value</source>
        <translation>einen Parameter mit Wert verwenden</translation>
    </message>
    <message>
        <source>{} must be Boolean, not {}</source>
        <translation>{} muss Boolean sein, nicht {}</translation>
    </message>
    <message>
        <source>the type '{}' is defined through itself</source>
        <translation>der Typ „{}“ ist durch sich selbst definiert</translation>
    </message>
    <message>
        <source>'{}' names a class within '{}', which is redeclared; that is not supported</source>
        <translation>„{}“ nennt eine Klasse innerhalb von „{}“, die neu deklariert wird; das wird nicht unterstützt</translation>
    </message>
    <message>
        <source>declare the inner class as &quot;replaceable&quot; itself and redeclare that one</source>
        <translation>die innere Klasse selbst als „replaceable“ deklarieren und diese neu deklarieren</translation>
    </message>
    <message>
        <source>the class '{}' is redeclared by a class with a body</source>
        <translation>die Klasse „{}“ wird durch eine Klasse mit eigenem Inhalt neu deklariert</translation>
    </message>
    <message>
        <source>write: redeclare model NAME = CLASS</source>
        <translation>schreiben: redeclare model NAME = KLASSE</translation>
    </message>
    <message>
        <source>the class '{}' is not known in '{}'</source>
        <translation>die Klasse „{}“ ist in „{}“ nicht bekannt</translation>
    </message>
    <message>
        <source>'{}' is inherited by {}, which modifies what it inherits; that is not supported for the classes of a package</source>
        <translation>„{}“ wird von {} geerbt, das Geerbtes modifiziert; das wird für die Klassen eines Pakets nicht unterstützt</translation>
    </message>
    <message>
        <source>use {} and modify its parameters</source>
        <translation>{} verwenden und seine Parameter modifizieren</translation>
    </message>
    <message>
        <source>{} cannot take the place of {}: {}</source>
        <translation>{} kann {} nicht ersetzen: {}</translation>
    </message>
    <message>
        <source>use a class that extends {}</source>
        <translation>eine Klasse verwenden, die {} erweitert</translation>
    </message>
    <message>
        <source>it is of another type</source>
        <translation>es ist von anderem Typ</translation>
    </message>
    <message>
        <source>it has no '{}'</source>
        <translation>es hat kein „{}“</translation>
    </message>
    <message>
        <source>The model '{}' has no parameter '{}'.</source>
        <translation>Das Modell „{}“ hat keinen Parameter „{}“.</translation>
    </message>
    <message>
        <source>'{}' is not a parameter and cannot be varied.</source>
        <translation>„{}“ ist kein Parameter und kann nicht verändert werden.</translation>
    </message>
    <message>
        <source>Only parameters of number type can be varied.</source>
        <translation>Nur Parameter, die Zahlen sind, können verändert werden.</translation>
    </message>
    <message>
        <source>The parameter '{}' has no value.</source>
        <translation>Der Parameter „{}“ hat keinen Wert.</translation>
    </message>
    <message>
        <source>Give it a value to start from in the model.</source>
        <translation>Ihm im Modell einen Wert geben, von dem aus zu beginnen ist.</translation>
    </message>
    <message>
        <source>The value of the parameter '{}' depends on itself.</source>
        <translation>Der Wert des Parameters „{}“ hängt von sich selbst ab.</translation>
    </message>
    <message>
        <source>Break the circle by giving one of the parameters a number.</source>
        <translation>Den Kreis aufbrechen, indem einer der Parameter eine Zahl bekommt.</translation>
    </message>
    <message>
        <source>The parameter '{}' has no value; its start value is used.</source>
        <translation>Der Parameter „{}“ hat keinen Wert; sein Startwert wird verwendet.</translation>
    </message>
    <message>
        <source>Give it a value where the component is declared.</source>
        <translation>Ihm einen Wert geben, wo das Bauteil deklariert ist.</translation>
    </message>
    <message>
        <source>The value of the parameter '{}' depends on '{}', which varies in time.</source>
        <translation>Der Wert des Parameters „{}“ hängt von „{}“ ab, das sich mit der Zeit ändert.</translation>
    </message>
    <message>
        <source>The initial equation {} is not used: the start is decided without it.</source>
        <translation>Die Anfangsgleichung {} wird nicht verwendet: Der Start liegt ohne sie fest.</translation>
    </message>
    <message>
        <source>Remove it, or free one of the other start conditions.</source>
        <translation>Sie entfernen, oder eine der anderen Startbedingungen freigeben.</translation>
    </message>
    <message>
        <source>The fixed start value of '{}' is not used: the start is decided without it.</source>
        <translation>Der feste Startwert von „{}“ wird nicht verwendet: Der Start liegt ohne ihn fest.</translation>
    </message>
    <message>
        <source>Remove fixed = true here, or free one of the other start conditions.</source>
        <translation>Hier fixed = true entfernen, oder eine der anderen Startbedingungen freigeben.</translation>
    </message>
    <message>
        <source>No start value is given for {}; 0 is taken.</source>
        <translation>Für {} ist kein Startwert angegeben; 0 wird angenommen.</translation>
    </message>
    <message>
        <source>inner</source>
        <translation>inner</translation>
    </message>
    <message>
        <source>outer</source>
        <translation>outer</translation>
    </message>
    <message>
        <source>it looks like an offset of {:+.3g}{} in this recording alone ({:.3g}{} remain without it)</source>
        <translation>es sieht nach einem Versatz von {}{} nur in dieser Aufzeichnung aus ({}{} bleiben ohne ihn)</translation>
    </message>
    <message>
        <source>it looks like a gain of {:.4g} in this recording alone ({:.3g}{} remain without it)</source>
        <translation>es sieht nach einer Verstärkung von {} nur in dieser Aufzeichnung aus ({}{} bleiben ohne sie)</translation>
    </message>
    <message>
        <source>neither an offset ({:+.3g}{} at best, {:.3g}{} remain) nor a gain ({:.4g}, {:.3g}{} remain) accounts for it: this recording shows what the fitted ones do not</source>
        <translation>weder ein Versatz (bestenfalls {}{}, {}{} bleiben) noch eine Verstärkung ({}, {}{} bleiben) erklärt das: Diese Aufzeichnung zeigt etwas, das die angepassten nicht zeigen</translation>
    </message>
    <message>
        <source>'{}': {} is off by {:.3g}{}{} (root mean square), {:.2g} times what is left in the fitted recordings; {}</source>
        <translation>„{}“: {} liegt um {}{}{} daneben (quadratisches Mittel), das {}-Fache dessen, was in den angepassten Aufzeichnungen bleibt; {}</translation>
    </message>
    <message>
        <source>a command that is held between its samples looks like half a sample of dead time, since inputs run linearly between theirs here</source>
        <translation>ein Befehl, der zwischen seinen Abtastwerten gehalten wird, sieht nach einem halben Abtastschritt Totzeit aus, denn Eingänge verlaufen hier zwischen den Abtastwerten linear</translation>
    </message>
    <message>
        <source>when exactly within the interval each channel was sampled may be all there is to it</source>
        <translation>vielleicht liegt es nur daran, wann genau innerhalb des Abtastschritts jeder Kanal abgetastet wurde</translation>
    </message>
    <message>
        <source>the dead time of {:.3g} s at {} is {:.2g} samples long: what is stored (in a mass, by a lag) comes late as well, and smoothed; a step of the input tells which of them it is</source>
        <translation>die Totzeit von {:.3g} s an {} ist {:.2g} Abtastwerte lang: Was gespeichert wird (in einer Masse, durch eine Verzögerung), kommt ebenfalls spät, und geglättet; ein Sprung des Eingangs sagt, was davon es ist</translation>
    </message>
    <message>
        <source>the dead time of {:.3g} s at {} is {:.2g} of a sample interval ({:.3g} s): {}</source>
        <translation>die Totzeit von {} s an {} beträgt das {}-Fache eines Abtastschritts ({} s): {}</translation>
    </message>
    <message>
        <source>the noise on output '{}' of '{}' comes and goes, by a factor of {:.2g}: in units of what it is near each sample, what is left there is noise</source>
        <translation>das Rauschen am Ausgang „{}“ von „{}“ kommt und geht, um das {}-Fache: Gemessen daran, wie stark es bei jedem Abtastwert ist, bleibt dort nur Rauschen übrig</translation>
    </message>
    <message>
        <source>what is left on output '{}' of '{}' is noise with a memory ({:.2g} s): it moves with nothing that is recorded or simulated, and is taken for noise of the measurement</source>
        <translation>was am Ausgang „{}“ von „{}“ übrig bleibt, ist Rauschen mit Gedächtnis ({} s): Es geht mit nichts einher, was aufgezeichnet oder simuliert ist, und wird für Rauschen der Messung genommen</translation>
    </message>
    <message>
        <source>the input '{}' of '{}' is recorded with noise ({:.2g} rms) that drives the model and not the component: the search has smoothed it, the errors that are reported are with it; record it with less noise, or smooth it</source>
        <translation>der Eingang „{}“ von „{}“ ist mit Rauschen aufgezeichnet (Effektivwert {}), das das Modell antreibt und nicht das Bauteil: Die Suche hat es geglättet, die angegebenen Fehler gelten mit ihm; den Eingang rauschärmer aufzeichnen oder glätten</translation>
    </message>
    <message>
        <source>'{}' does not begin where the model was told: {} is {}{}{} there, not {:.5g}; it is fitted for this recording (&quot;initial&quot;: &quot;fit&quot;)</source>
        <translation>„{}“ beginnt nicht dort, wo es dem Modell gesagt wurde: {} ist dort {}{}{}, nicht {}; der Wert wird für diese Aufzeichnung angepasst (&quot;initial&quot;: &quot;fit&quot;)</translation>
    </message>
    <message>
        <source>'{}' does not begin where the model was told: what it begins with is estimated from it alone, and its errors are with that ({}; say so in the study with &quot;initial&quot;: &quot;fit&quot;)</source>
        <translation>Die Aufzeichnung „{}“ beginnt nicht dort, wo es dem Modell gesagt wurde: Womit sie beginnt, ist aus ihr allein geschätzt, und ihre Fehler gelten damit ({}; in der Studie mit &quot;initial&quot;: &quot;fit&quot; angeben)</translation>
    </message>
    <message>
        <source>{} beyond its bound of {:.5g} explains more than any effect: {}{} fits; widen the bound</source>
        <translation>{} jenseits seiner Grenze von {} erklärt mehr als jeder Effekt: {}{} passt; die Grenze erweitern</translation>
    </message>
    <message>
        <source>{} of {}{} instead of {:.5g} explains as much: the data do not tell which is wrong</source>
        <translation>{} mit {}{} statt {} erklärt ebenso viel: Die Daten sagen nicht, welcher Wert falsch ist</translation>
    </message>
    <message>
        <source>another value of {} explains more than any effect: it is held at {:.5g}, and {}{} fits; correct it, or let it be fitted</source>
        <translation>ein anderer Wert von {} erklärt mehr als jeder Effekt: Er ist auf {} festgehalten, und {}{} passt; berichtigen oder anpassen lassen</translation>
    </message>
    <message>
        <source>an equation without a name explains as much as {} at {}, and the data do not tell them apart: {}</source>
        <translation>eine Gleichung ohne Namen erklärt so viel wie {} bei {}, und die Daten unterscheiden beide nicht: {}</translation>
    </message>
    <message>
        <source>{} at {} explains as much with more parameters: {}</source>
        <translation>{} bei {} erklärt so viel mit mehr Parametern: {}</translation>
    </message>
    <message>
        <source>Only outputs may have empty cells.</source>
        <translation>Nur Ausgänge dürfen leere Zellen haben.</translation>
    </message>
    <message>
        <source>there is no channel '{}'</source>
        <translation>es gibt keinen Kanal „{}“</translation>
    </message>
    <message>
        <source>An input that is written only now and then is told how it runs between: &quot;interpolation&quot;: &quot;hold&quot; or &quot;linear&quot;.</source>
        <translation>Zu einem Eingang, der nur ab und zu geschrieben wird, gehört, wie er dazwischen verläuft: &quot;interpolation&quot;: &quot;hold&quot; oder &quot;linear&quot;.</translation>
    </message>
    <message>
        <source>column '{}' was not measured at any stamp of the raster</source>
        <translation>Spalte „{}“ wurde an keinem Zeitpunkt des Rasters gemessen</translation>
    </message>
    <message>
        <source>Choose another &quot;raster&quot;, or leave the channel out.</source>
        <translation>Ein anderes &quot;raster&quot; wählen oder den Kanal weglassen.</translation>
    </message>
    <message>
        <source>the name of a column, or {{&quot;column&quot;: …, &quot;group&quot;: …}}</source>
        <translation>den Namen einer Spalte oder {{&quot;column&quot;: …, &quot;group&quot;: …}}</translation>
    </message>
    <message>
        <source>the name of a column</source>
        <translation>der Name einer Spalte</translation>
    </message>
    <message>
        <source>{}: the group and the sheet of a column are the same thing</source>
        <translation>{}: Gruppe und Blatt einer Spalte sind dasselbe</translation>
    </message>
    <message>
        <source>the name of a group or its number, the first being 1</source>
        <translation>den Namen einer Gruppe oder ihre Nummer, die erste ist 1</translation>
    </message>
    <message>
        <source>{}: the step of a raster must be above 0 s</source>
        <translation>{}: Der Schritt eines Rasters muss über 0 s liegen</translation>
    </message>
    <message>
        <source>&quot;outputs&quot;, the name of a channel, or a step in seconds</source>
        <translation>&quot;outputs&quot;, den Namen eines Kanals oder einen Schritt in Sekunden</translation>
    </message>
    <message>
        <source>how the text is written, as {{&quot;separator&quot;: &quot;;&quot;, &quot;decimal&quot;: &quot;,&quot;}}</source>
        <translation>wie der Text geschrieben ist, etwa {{&quot;separator&quot;: &quot;;&quot;, &quot;decimal&quot;: &quot;,&quot;}}</translation>
    </message>
    <message>
        <source>, ; | a tab (\t) or a blank</source>
        <translation>, ; | einen Tabulator (\t) oder ein Leerzeichen</translation>
    </message>
    <message>
        <source>. or ,</source>
        <translation>. oder ,</translation>
    </message>
    <message>
        <source>. , ' or a blank</source>
        <translation>. , ' oder ein Leerzeichen</translation>
    </message>
    <message>
        <source>{}: one mark cannot be that of the decimals and another one too</source>
        <translation>{}: Ein Zeichen kann nicht zugleich das der Dezimalstellen und ein anderes sein</translation>
    </message>
    <message>
        <source>&quot;read&quot;</source>
        <translation>&quot;read&quot;</translation>
    </message>
    <message>
        <source>a number of lines, 0 or more</source>
        <translation>eine Zahl von Zeilen, 0 oder mehr</translation>
    </message>
    <message>
        <source>experiment '{}': '{}' has {} channels '{}'</source>
        <translation>Versuch „{}“: „{}“ hat {} Kanäle „{}“</translation>
    </message>
    <message>
        <source>Say which: {{&quot;column&quot;: &quot;{}&quot;, &quot;group&quot;: …}}, one of {}.</source>
        <translation>Sagen, welcher: {{&quot;column&quot;: &quot;{}&quot;, &quot;group&quot;: …}}, einer von {}.</translation>
    </message>
    <message>
        <source>experiment '{}': '{}' has no channel '{}' in this group</source>
        <translation>Versuch „{}“: „{}“ hat keinen Kanal „{}“ in dieser Gruppe</translation>
    </message>
    <message>
        <source>It is in {}.</source>
        <translation>Er ist in {}.</translation>
    </message>
    <message>
        <source>the only table of the file</source>
        <translation>der einzigen Tabelle der Datei</translation>
    </message>
    <message>
        <source>It holds words. If they are stamps of the time, tell how they are written: &quot;read&quot;: {{&quot;time_format&quot;: &quot;%d.%m.%Y %H:%M:%S&quot;}}.</source>
        <translation>Sie enthält Wörter. Sind es Zeitstempel, so gehört dazu, wie sie geschrieben sind: &quot;read&quot;: {{&quot;time_format&quot;: &quot;%d.%m.%Y %H:%M:%S&quot;}}.</translation>
    </message>
    <message>
        <source>group &quot;{}&quot; has no time</source>
        <translation>Gruppe „{}“ hat keine Zeit</translation>
    </message>
    <message>
        <source>Name the column of its stamps: &quot;time&quot;: {{&quot;column&quot;: …, &quot;group&quot;: …}}; or take channels of another group.</source>
        <translation>Die Spalte ihrer Zeitstempel nennen: &quot;time&quot;: {{&quot;column&quot;: …, &quot;group&quot;: …}}; oder Kanäle einer anderen Gruppe nehmen.</translation>
    </message>
    <message>
        <source>none of the outputs was measured at any time</source>
        <translation>keiner der Ausgänge wurde irgendwann gemessen</translation>
    </message>
    <message>
        <source>a raster of {:g} s has {:.3g} stamps in {:.6g} s of this recording</source>
        <translation>ein Raster von {} s hat {} Zeitpunkte in den {} s dieser Aufzeichnung</translation>
    </message>
    <message>
        <source>Give a longer step.</source>
        <translation>Einen größeren Schritt angeben.</translation>
    </message>
    <message>
        <source>{} of {} values of '{}' lie on no stamp of the raster and are not compared</source>
        <translation>{} von {} Werten von „{}“ liegen auf keinem Zeitpunkt des Rasters und werden nicht verglichen</translation>
    </message>
    <message>
        <source>An output is never resampled: take the raster &quot;outputs&quot;, or that of its own channel.</source>
        <translation>Ein Ausgang wird nie umgetastet: Das Raster &quot;outputs&quot; nehmen oder das seines eigenen Kanals.</translation>
    </message>
    <message>
        <source>the outputs are recorded from {:.6g} s to {:.6g} s, the input '{}' is not known in that time</source>
        <translation>die Ausgänge sind von {} s bis {} s aufgezeichnet, der Eingang „{}“ ist in dieser Zeit nicht bekannt</translation>
    </message>
    <message>
        <source>Map a channel that was recorded at the same time.</source>
        <translation>Einen Kanal zuordnen, der zur selben Zeit aufgezeichnet wurde.</translation>
    </message>
    <message>
        <source>from {:.6g} s to {:.6g} s all inputs are known; {} of {} stamps of the outputs lie outside and are left out</source>
        <translation>von {} s bis {} s sind alle Eingänge bekannt; {} von {} Zeitpunkten der Ausgänge liegen außerhalb und bleiben weg</translation>
    </message>
    <message>
        <source>The input '{}' is recorded for a shorter time.</source>
        <translation>Der Eingang „{}“ ist über eine kürzere Zeit aufgezeichnet.</translation>
    </message>
    <message>
        <source>between the stamps of the raster the input '{}' departs from straight lines by up to {:.2g} % of its range</source>
        <translation>zwischen den Zeitpunkten des Rasters weicht der Eingang „{}“ um bis zu {} % seines Bereichs von Geraden ab</translation>
    </message>
    <message>
        <source>Where that matters take its stamps: &quot;raster&quot;: &quot;{}&quot;.</source>
        <translation>Wo das zählt, seine Zeitpunkte nehmen: &quot;raster&quot;: &quot;{}&quot;.</translation>
    </message>
    <message>
        <source>this file has no samples of any channel</source>
        <translation>diese Datei hat von keinem Kanal Messwerte</translation>
    </message>
    <message>
        <source>Is it the recording? 'analogon-cli channels' lists what it holds.</source>
        <translation>Ist es die Aufzeichnung? „analogon-cli channels“ zählt auf, was sie enthält.</translation>
    </message>
    <message>
        <source>this file is large: {} of its channels, which the study does not name, are left unread and are not looked at as causes</source>
        <translation>diese Datei ist groß: {} ihrer Kanäle, die die Studie nicht nennt, bleiben ungelesen und werden nicht als Ursachen betrachtet</translation>
    </message>
    <message>
        <source>Map what may be a cause, or export the recording with fewer channels.</source>
        <translation>Zuordnen, was eine Ursache sein kann, oder die Aufzeichnung mit weniger Kanälen ausgeben.</translation>
    </message>
    <message>
        <source>&quot;read&quot; tells how a text is written, and this is {}: it has no effect</source>
        <translation>&quot;read&quot; sagt, wie ein Text geschrieben ist, und dies ist {}: Es bewirkt nichts</translation>
    </message>
    <message>
        <source>column '{}' was not measured in {} of {} rows, first in data row {}</source>
        <translation>Spalte „{}“ wurde in {} von {} Zeilen nicht gemessen, zuerst in Datenzeile {}</translation>
    </message>
    <message>
        <source>What the model says there is compared with nothing.</source>
        <translation>Was das Modell dort sagt, wird mit nichts verglichen.</translation>
    </message>
    <message>
        <source>Only numbers can be read; leave the cell of an output empty where it was not measured.</source>
        <translation>Nur Zahlen können gelesen werden; die Zelle eines Ausgangs leer lassen, wo er nicht gemessen wurde.</translation>
    </message>
    <message>
        <source>{} at {} explains no more than another value of {}, which is held at {:.5g}: {}{} instead; hold it only if it is known for certain</source>
        <translation>{} bei {} erklärt nicht mehr als ein anderer Wert von {}, gehalten bei {}: stattdessen {}{}; nur halten, wenn er sicher bekannt ist</translation>
    </message>
    <message>
        <source>{} at {} explains no more than {} beyond its bound of {:.5g}: {}{} instead; keep the bound only if it is known for certain</source>
        <translation>{} bei {} erklärt nicht mehr als {} jenseits seiner Grenze von {}: stattdessen {}{}; die Grenze nur behalten, wenn sie sicher bekannt ist</translation>
    </message>
    <message>
        <source>iteration {}</source>
        <translation>Iteration {}</translation>
    </message>
    <message>
        <source>noise of the inputs</source>
        <translation>Rauschen der Eingänge</translation>
    </message>
    <message>
        <source>clocks of the inputs</source>
        <translation>Uhren der Eingänge</translation>
    </message>
    <message>
        <source>parameters that change</source>
        <translation>Parameter, die sich ändern</translation>
    </message>
    <message>
        <source>a parameter that changes is the better account</source>
        <translation>ein Parameter, der sich ändert, erklärt es besser</translation>
    </message>
    <message>
        <source>jumps of the inputs</source>
        <translation>Sprünge der Eingänge</translation>
    </message>
    <message>
        <source>a law for what is left</source>
        <translation>ein Gesetz für den Rest</translation>
    </message>
    <message>
        <source>{} at every channel like {}</source>
        <translation>{} an jedem Kanal wie {}</translation>
    </message>
    <message>
        <source>{} at {}</source>
        <translation>{} bei {}</translation>
    </message>
    <message>
        <source>{} at {} for {}</source>
        <translation>{} bei {} statt {}</translation>
    </message>
    <message>
        <source>simulation {}</source>
        <translation>Simulation {}</translation>
    </message>
    <message>
        <source>the traces of this run cannot be read: {}</source>
        <translation>die Kurven dieses Laufs sind nicht lesbar: {}</translation>
    </message>
    <message>
        <source>a run of the history cannot be read: {}</source>
        <translation>ein Lauf der Historie ist nicht lesbar: {}</translation>
    </message>
    <message>
        <source>{} recordings of that run are not part of the study any more</source>
        <translation>{} Aufzeichnungen dieses Laufs gehören nicht mehr zur Studie</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is a word of the language; choose another name</source>
        <translation>„{}“ ist ein Wort der Sprache; einen anderen Namen wählen</translation>
    </message>
    <message>
        <source>expected &quot;;&quot; after {}, found {}</source>
        <translation>erwartet: „;“ nach {}, gefunden: {}</translation>
    </message>
    <message>
        <source>expected &quot;;&quot; after {}</source>
        <translation>erwartet: „;“ nach {}</translation>
    </message>
    <message>
        <source>too many faults: the rest of the text was not read</source>
        <translation>zu viele Fehler: Der Rest des Textes wurde nicht gelesen</translation>
    </message>
    <message>
        <source>expected {}, found {}</source>
        <translation>erwartet: {}, gefunden: {}</translation>
    </message>
    <message>
        <source>the end of the text</source>
        <translation>das Ende des Textes</translation>
    </message>
    <message>
        <source>a string</source>
        <translation>eine Zeichenkette</translation>
    </message>
    <message>
        <source>the string {}</source>
        <translation>die Zeichenkette {}</translation>
    </message>
    <message>
        <source>the number {:.30}</source>
        <translation>die Zahl {}</translation>
    </message>
    <message>
        <source>&quot;{:.60}&quot;</source>
        <translation>„{}“</translation>
    </message>
    <message>
        <source>{} would take {:.3g} GB of memory, of {:.3g} GB that the machine has</source>
        <translation>{} bräuchte {:.3g} GB Speicher, von {:.3g} GB, die der Rechner hat</translation>
    </message>
    <message>
        <source>the traces of {} inputs and {} outputs over {:.3g} samples</source>
        <translation>die Verläufe von {} Eingängen und {} Ausgängen über {:.3g} Abtastwerte</translation>
    </message>
    <message>
        <source>the slopes of {:.3g} measured values along {} parameters</source>
        <translation>die Steigungen von {:.3g} Messwerten nach {} Parametern</translation>
    </message>
    <message>
        <source>the {} expressions of the model</source>
        <translation>die {} Ausdrücke des Modells</translation>
    </message>
    <message>
        <source>the equations of the model refer to its variables more than {} times</source>
        <translation>die Gleichungen des Modells nennen seine Größen mehr als {}-mal</translation>
    </message>
    <message>
        <source>Give a sum that stands in many equations a variable of its own.</source>
        <translation>Einer Summe, die in vielen Gleichungen steht, eine eigene Größe geben.</translation>
    </message>
    <message>
        <source>{} equations for {}, {} and {} more must be solved at once, in more than {} unknowns</source>
        <translation>{} Gleichungen für {}, {} und {} weitere müssten auf einmal gelöst werden, nach mehr als {} Unbekannten</translation>
    </message>
    <message>
        <source>Break the loop: let some of its quantities follow with a small inertia, capacity or lag, or model fewer parts.</source>
        <translation>Die Schleife auftrennen: einige ihrer Größen mit einer kleinen Trägheit, Kapazität oder Verzögerung folgen lassen, oder weniger Teile modellieren.</translation>
    </message>
    <message>
        <source>Export fewer channels, or a part of the recording.</source>
        <translation>Weniger Kanäle oder einen Teil der Aufzeichnung exportieren.</translation>
    </message>
    <message>
        <source>Use a part of the recordings (&quot;range&quot;), fewer of their rows, or fewer outputs of the model.</source>
        <translation>Einen Teil der Aufzeichnungen („range“), weniger Zeilen oder weniger Ausgänge des Modells verwenden.</translation>
    </message>
    <message>
        <source>Use a part of the recordings (&quot;range&quot;), fewer of their rows, or fit fewer parameters.</source>
        <translation>Einen Teil der Aufzeichnungen („range“), weniger Zeilen verwenden oder weniger Parameter anpassen.</translation>
    </message>
    <message>
        <source>the file has {:.3g} MB, more than the {} MB that are read</source>
        <translation>die Datei hat {:.3g} MB, mehr als die {} MB, die gelesen werden</translation>
    </message>
    <message>
        <source>Measured values belong into files of their own.</source>
        <translation>Messwerte gehören in eigene Dateien.</translation>
    </message>
    <message>
        <source>objects and lists stand within each other more than {} deep</source>
        <translation>Objekte und Listen stehen tiefer als {} Ebenen ineinander</translation>
    </message>
    <message>
        <source>A study needs fewer than ten levels.</source>
        <translation>Eine Studie braucht weniger als zehn Ebenen.</translation>
    </message>
    <message>
        <source>the file has more than {} values</source>
        <translation>die Datei hat mehr als {} Werte</translation>
    </message>
    <message>
        <source>the names in this file are too long and too many</source>
        <translation>die Namen in dieser Datei sind zu lang und zu viele</translation>
    </message>
    <message>
        <source>This is a fault of the program. Please report it with the study that led to it.</source>
        <translation>Das ist ein Fehler des Programms. Bitte mit der Studie melden, die dazu geführt hat.</translation>
    </message>
    <message>
        <source>there is not enough memory for this</source>
        <translation>dafür reicht der Speicher nicht</translation>
    </message>
    <message>
        <source>Use a part of the recordings (&quot;range&quot;), fewer of their columns or rows, a smaller model, or a machine with more memory.</source>
        <translation>Einen Teil der Aufzeichnungen („range“), weniger Spalten oder Zeilen, ein kleineres Modell oder einen Rechner mit mehr Speicher verwenden.</translation>
    </message>
    <message>
        <source>this is too large to be worked out</source>
        <translation>das ist zu groß, um ausgerechnet zu werden</translation>
    </message>
    <message>
        <source>Use a part of the recordings (&quot;range&quot;), or a smaller model.</source>
        <translation>Einen Teil der Aufzeichnungen („range“) oder ein kleineres Modell verwenden.</translation>
    </message>
    <message>
        <source>the file cannot be read or written: {}</source>
        <translation>die Datei lässt sich nicht lesen oder schreiben: {}</translation>
    </message>
    <message>
        <source>the system refuses what the program asks for: {}</source>
        <translation>das System verweigert, was das Programm verlangt: {}</translation>
    </message>
    <message>
        <source>Check the limits of the system (ulimit -a) and the space on the disk.</source>
        <translation>Die Grenzen des Systems (ulimit -a) und den Platz auf dem Datenträger prüfen.</translation>
    </message>
    <message>
        <source>an error that was not foreseen: {}</source>
        <translation>ein unvorhergesehener Fehler: {}</translation>
    </message>
    <message>
        <source>an error that was not foreseen</source>
        <translation>ein unvorhergesehener Fehler</translation>
    </message>
    <message>
        <source>the equations of the model, or their derivatives, take more than {} expressions</source>
        <translation>die Gleichungen des Modells oder ihre Ableitungen brauchen mehr als {} Ausdrücke</translation>
    </message>
    <message>
        <source>Shorten the longest equations and loops, or give intermediate results names of their own.</source>
        <translation>Die längsten Gleichungen und Schleifen kürzen oder Zwischenergebnissen eigene Namen geben.</translation>
    </message>
    <message>
        <source>nested deeper than {} levels</source>
        <translation>tiefer als {} Ebenen verschachtelt</translation>
    </message>
    <message>
        <source>name an intermediate result</source>
        <translation>einem Zwischenergebnis einen Namen geben</translation>
    </message>
    <message>
        <source>&quot;{}&quot; {}</source>
        <translation>„{}“ {}</translation>
    </message>
    <message>
        <source>a class</source>
        <translation>eine Klasse</translation>
    </message>
    <message>
        <source>a Modelica file holds classes: model A … end A;</source>
        <translation>eine Modelica-Datei enthält Klassen: model A … end A;</translation>
    </message>
    <message>
        <source>the class &quot;{}&quot;</source>
        <translation>der Klasse „{}“</translation>
    </message>
    <message>
        <source>the text holds no class</source>
        <translation>der Text enthält keine Klasse</translation>
    </message>
    <message>
        <source>the kind of a class: model, block, connector, record, type or package</source>
        <translation>die Art einer Klasse: model, block, connector, record, type oder package</translation>
    </message>
    <message>
        <source>&quot;{} extends&quot; not supported</source>
        <translation>„{} extends“ wird nicht unterstützt</translation>
    </message>
    <message>
        <source>give the class a name of its own and inherit with &quot;extends Base(…);&quot;</source>
        <translation>der Klasse einen eigenen Namen geben und mit „extends Basis(…);“ erben</translation>
    </message>
    <message>
        <source>the name of the {}</source>
        <translation>der Name nach „{}“</translation>
    </message>
    <message>
        <source>classes by differentiation, &quot;= der(…)&quot;, are not supported</source>
        <translation>Klassen durch Ableitung, „= der(…)“, werden nicht unterstützt</translation>
    </message>
    <message>
        <source>write the derivative as an equation</source>
        <translation>die Ableitung als Gleichung schreiben</translation>
    </message>
    <message>
        <source>open enumerations, &quot;(:)&quot;, are not supported</source>
        <translation>offene Aufzählungen, „(:)“, werden nicht unterstützt</translation>
    </message>
    <message>
        <source>list the literals</source>
        <translation>die Literale aufzählen</translation>
    </message>
    <message>
        <source>a second annotation of &quot;{}&quot;</source>
        <translation>eine zweite annotation von „{}“</translation>
    </message>
    <message>
        <source>a class has one annotation, as its last element</source>
        <translation>eine Klasse hat eine annotation, als letztes Element</translation>
    </message>
    <message>
        <source>the annotation of &quot;{}&quot; is not its last element</source>
        <translation>die annotation von „{}“ ist nicht das letzte Element</translation>
    </message>
    <message>
        <source>move it right before the &quot;end&quot;</source>
        <translation>sie unmittelbar vor das „end“ setzen</translation>
    </message>
    <message>
        <source>the {} &quot;{}&quot; is not closed</source>
        <translation>{} „{}“ ist nicht abgeschlossen</translation>
    </message>
    <message>
        <source>it ends with &quot;end {};&quot;</source>
        <translation>der Abschluss ist „end {};“</translation>
    </message>
    <message>
        <source>expected the name of the class behind &quot;end&quot;</source>
        <translation>erwartet: der Name der Klasse hinter „end“</translation>
    </message>
    <message>
        <source>write &quot;end {};&quot;</source>
        <translation>„end {};“ schreiben</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is closed by the name &quot;{}&quot;</source>
        <translation>„{}“ ist mit dem Namen „{}“ abgeschlossen</translation>
    </message>
    <message>
        <source>the {} &quot;{}&quot;</source>
        <translation>{} „{}“</translation>
    </message>
    <message>
        <source>the prefix &quot;{}&quot; is doubled or out of order</source>
        <translation>das Präfix „{}“ steht doppelt oder an falscher Stelle</translation>
    </message>
    <message>
        <source>the order is: flow, then parameter, constant or discrete, then input or output</source>
        <translation>die Reihenfolge ist: flow, dann parameter, constant oder discrete, dann input oder output</translation>
    </message>
    <message>
        <source>a declaration, an equation section or &quot;end&quot;</source>
        <translation>eine Deklaration, ein Abschnitt mit Gleichungen oder „end“</translation>
    </message>
    <message>
        <source>the name of a component of type &quot;{}&quot;</source>
        <translation>der Name einer Komponente vom Typ „{}“</translation>
    </message>
    <message>
        <source>&quot;:=&quot; is an assignment</source>
        <translation>„:=“ ist eine Zuweisung</translation>
    </message>
    <message>
        <source>a value is given with &quot;=&quot;</source>
        <translation>ein Wert wird mit „=“ angegeben</translation>
    </message>
    <message>
        <source>a declaration of three names</source>
        <translation>eine Deklaration aus drei Namen</translation>
    </message>
    <message>
        <source>did you mean &quot;{}&quot;?</source>
        <translation>ist „{}“ gemeint?</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is declared twice in &quot;{}&quot;</source>
        <translation>„{}“ ist in „{}“ zweimal deklariert</translation>
    </message>
    <message>
        <source>the first declaration is in line {}, column {}</source>
        <translation>die erste Deklaration steht in Zeile {}, Spalte {}</translation>
    </message>
    <message>
        <source>&quot;within&quot;</source>
        <translation>„within“</translation>
    </message>
    <message>
        <source>the name of a literal</source>
        <translation>der Name eines Literals</translation>
    </message>
    <message>
        <source>the annotation</source>
        <translation>der annotation</translation>
    </message>
    <message>
        <source>the name of the class behind &quot;end&quot;</source>
        <translation>der Name der Klasse hinter „end“</translation>
    </message>
    <message>
        <source>the name of a class</source>
        <translation>der Name einer Klasse</translation>
    </message>
    <message>
        <source>the name of a class or package</source>
        <translation>der Name einer Klasse oder eines Pakets</translation>
    </message>
    <message>
        <source>the import</source>
        <translation>dem import</translation>
    </message>
    <message>
        <source>&quot;extends&quot;</source>
        <translation>„extends“</translation>
    </message>
    <message>
        <source>the declaration</source>
        <translation>der Deklaration</translation>
    </message>
    <message>
        <source>behind &quot;enumeration&quot;</source>
        <translation>hinter „enumeration“</translation>
    </message>
    <message>
        <source>to close the enumeration</source>
        <translation>zum Schließen der Aufzählung</translation>
    </message>
    <message>
        <source>here</source>
        <translation>an dieser Stelle</translation>
    </message>
    <message>
        <source>to close the list of imports</source>
        <translation>zum Schließen der Liste von Importen</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is no kind of class</source>
        <translation>„{}“ ist keine Art von Klasse</translation>
    </message>
    <message>
        <source>&quot;=&quot; is an equation</source>
        <translation>„=“ ist eine Gleichung</translation>
    </message>
    <message>
        <source>a statement is written with &quot;:=&quot;</source>
        <translation>eine Anweisung schreibt man mit „:=“</translation>
    </message>
    <message>
        <source>&quot;:=&quot; in the statement</source>
        <translation>„:=“ in der Anweisung</translation>
    </message>
    <message>
        <source>the arguments of the external function</source>
        <translation>die Argumente der externen Funktion</translation>
    </message>
    <message>
        <source>a named argument, such as &quot;k = 1&quot;</source>
        <translation>ein benanntes Argument, etwa „k = 1“</translation>
    </message>
    <message>
        <source>behind &quot;der&quot;</source>
        <translation>hinter „der“</translation>
    </message>
    <message>
        <source>behind the function that is differentiated</source>
        <translation>hinter der Funktion, die abgeleitet wird</translation>
    </message>
    <message>
        <source>the name of an input of the function</source>
        <translation>der Name eines Eingangs der Funktion</translation>
    </message>
    <message>
        <source>to close &quot;der&quot;</source>
        <translation>zum Schließen von „der“</translation>
    </message>
    <message>
        <source>the name of the element that is left out</source>
        <translation>der Name des Elements, das weggelassen wird</translation>
    </message>
    <message>
        <source>behind the name of the function</source>
        <translation>hinter dem Namen der Funktion</translation>
    </message>
    <message>
        <source>the statement</source>
        <translation>der Anweisung</translation>
    </message>
    <message>
        <source>the external function</source>
        <translation>der externen Funktion</translation>
    </message>
    <message>
        <source>a value is missing here</source>
        <translation>hier fehlt ein Wert</translation>
    </message>
    <message>
        <source>'{}': a member of an expression is not supported</source>
        <translation>'{}': ein Teil eines Ausdrucks wird nicht unterstützt</translation>
    </message>
    <message>
        <source>name the record by a variable of its own</source>
        <translation>den Datensatz durch eine eigene Variable benennen</translation>
    </message>
    <message>
        <source>'{}' has more than two dimensions and is no part of a matrix in brackets</source>
        <translation>'{}' hat mehr als zwei Dimensionen und kann nicht Teil einer Matrix in eckigen Klammern sein</translation>
    </message>
    <message>
        <source>{} and {} cannot stand side by side in one array</source>
        <translation>{} und {} können nicht nebeneinander in einem Feld stehen</translation>
    </message>
    <message>
        <source>'when' cannot stand in an initial equation section</source>
        <translation>„when“ kann nicht in einem Abschnitt „initial equation“ stehen</translation>
    </message>
    <message>
        <source>'when' cannot stand within an 'if' that changes</source>
        <translation>„when“ kann nicht in einem „if“ stehen, das sich ändert</translation>
    </message>
    <message>
        <source>'{}' has {} outputs, not {}</source>
        <translation>'{}' hat {} Ausgänge, nicht {}</translation>
    </message>
    <message>
        <source>'{}' has no member '{}'</source>
        <translation>'{}' hat kein Element '{}'</translation>
    </message>
    <message>
        <source>{} cannot be assigned to '{}'</source>
        <translation>{} kann '{}' nicht zugewiesen werden</translation>
    </message>
    <message>
        <source>'{}' needs the name of a variable</source>
        <translation>'{}' braucht den Namen einer Variablen</translation>
    </message>
    <message>
        <source>'sample' takes a start and an interval that are known before the simulation</source>
        <translation>„sample“ braucht einen Beginn und einen Abstand, die vor der Simulation bekannt sind</translation>
    </message>
    <message>
        <source>the condition after 'when' must be Boolean, not {}</source>
        <translation>die Bedingung hinter „when“ muss Boolean sein, nicht {}</translation>
    </message>
    <message>
        <source>'{}' cannot stand within 'when'</source>
        <translation>'{}' kann nicht in „when“ stehen</translation>
    </message>
    <message>
        <source>an equation within 'when' begins with the variable that it sets</source>
        <translation>eine Gleichung in „when“ beginnt mit der Variablen, die sie setzt</translation>
    </message>
    <message>
        <source>'reinit' needs a variable and its new value</source>
        <translation>„reinit“ braucht eine Variable und ihren neuen Wert</translation>
    </message>
    <message>
        <source>'{}' needs a Boolean condition and a text</source>
        <translation>'{}' braucht eine Bedingung vom Typ Boolean und einen Text</translation>
    </message>
    <message>
        <source>{}</source>
        <translation>{}</translation>
    </message>
    <message>
        <source>the function '{}' has no algorithm that could be run</source>
        <translation>die Funktion '{}' hat keinen Algorithmus, der ausgeführt werden könnte</translation>
    </message>
    <message>
        <source>functions call each other more than {} deep</source>
        <translation>Funktionen rufen einander mehr als {} tief auf</translation>
    </message>
    <message>
        <source>the argument '{}' of '{}' is not given</source>
        <translation>das Argument '{}' von '{}' fehlt</translation>
    </message>
    <message>
        <source>'{}' is not a variable of the function</source>
        <translation>'{}' ist keine Variable der Funktion</translation>
    </message>
    <message>
        <source>'break' and 'return' need a condition that is known before the simulation</source>
        <translation>„break“ und „return“ brauchen eine Bedingung, die vor der Simulation bekannt ist</translation>
    </message>
    <message>
        <source>use a for loop, or write the relation as equations</source>
        <translation>eine for-Schleife verwenden oder den Zusammenhang als Gleichungen schreiben</translation>
    </message>
    <message>
        <source>the loop runs more than {} times</source>
        <translation>die Schleife läuft mehr als {} Mal</translation>
    </message>
    <message>
        <source>'when' has no meaning in a function</source>
        <translation>„when“ hat in einer Funktion keine Bedeutung</translation>
    </message>
    <message>
        <source>the branches differ in a size or a text, and their condition is not known before the simulation</source>
        <translation>die Zweige unterscheiden sich in einer Größe oder einem Text, und ihre Bedingung ist vor der Simulation nicht bekannt</translation>
    </message>
    <message>
        <source>the algorithm could not be run</source>
        <translation>der Algorithmus konnte nicht ausgeführt werden</translation>
    </message>
    <message>
        <source>the external function '{}' is not known</source>
        <translation>die externe Funktion '{}' ist nicht bekannt</translation>
    </message>
    <message>
        <source>the external function '{}' gives nothing</source>
        <translation>die externe Funktion '{}' gibt nichts zurück</translation>
    </message>
    <message>
        <source>the table of '{}' must be known before the simulation</source>
        <translation>die Tabelle von '{}' muss vor der Simulation bekannt sein</translation>
    </message>
    <message>
        <source>random numbers of a generator with a hidden state are not supported</source>
        <translation>Zufallszahlen eines Generators mit verborgenem Zustand werden nicht unterstützt</translation>
    </message>
    <message>
        <source>draw them from a generator whose state is a variable: Modelica.Blocks.Noise, or Modelica.Math.Random.Generators</source>
        <translation>sie aus einem Generator ziehen, dessen Zustand eine Variable ist: Modelica.Blocks.Noise oder Modelica.Math.Random.Generators</translation>
    </message>
    <message>
        <source>the state of a random number generator has {} Integers here</source>
        <translation>der Zustand eines Zufallszahlengenerators hat hier {} Integer</translation>
    </message>
    <message>
        <source>'{}' stands in a function, which is no component</source>
        <translation>„{}“ steht in einer Funktion, die keine Komponente ist</translation>
    </message>
    <message>
        <source>the table &quot;{}&quot; of a function 'usertab' is not supported</source>
        <translation>die Tabelle „{}“ einer Funktion „usertab“ wird nicht unterstützt</translation>
    </message>
    <message>
        <source>give the table by its values or in a file</source>
        <translation>die Tabelle durch ihre Werte oder in einer Datei angeben</translation>
    </message>
    <message>
        <source>the columns of the table must be known before the simulation</source>
        <translation>die Spalten der Tabelle müssen vor der Simulation bekannt sein</translation>
    </message>
    <message>
        <source>the column of the table must be known before the simulation</source>
        <translation>die Spalte der Tabelle muss vor der Simulation bekannt sein</translation>
    </message>
    <message>
        <source>the table has no values</source>
        <translation>die Tabelle hat keine Werte</translation>
    </message>
    <message>
        <source>the text must be known before the simulation</source>
        <translation>der Text muss vor der Simulation bekannt sein</translation>
    </message>
    <message>
        <source>the table has {} columns, not {}</source>
        <translation>die Tabelle hat {} Spalten, nicht {}</translation>
    </message>
    <message>
        <source>a table of two dimensions is interpolated linearly, by Akima's method or in constant segments</source>
        <translation>eine Tabelle mit zwei Dimensionen wird linear, nach Akima oder in konstanten Stücken interpoliert</translation>
    </message>
    <message>
        <source>the size of the table &quot;{}&quot; cannot be read</source>
        <translation>die Größe der Tabelle „{}“ ist nicht lesbar</translation>
    </message>
    <message>
        <source>the table &quot;{}&quot; ends after {} of {} values</source>
        <translation>die Tabelle „{}“ endet nach {} von {} Werten</translation>
    </message>
    <message>
        <source>the file holds no table &quot;{}&quot;</source>
        <translation>die Datei enthält keine Tabelle „{}“</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is no number</source>
        <translation>„{}“ ist keine Zahl</translation>
    </message>
    <message>
        <source>the row has {} values, the first one {}</source>
        <translation>die Zeile hat {} Werte, die erste {}</translation>
    </message>
    <message>
        <source>'cat' takes a dimension and arrays</source>
        <translation>„cat“ braucht eine Dimension und Felder</translation>
    </message>
    <message>
        <source>'{}' needs a vector, not {}</source>
        <translation>'{}' braucht einen Vektor, nicht {}</translation>
    </message>
    <message>
        <source>'{}' needs a matrix, not {}</source>
        <translation>'{}' braucht eine Matrix, nicht {}</translation>
    </message>
    <message>
        <source>'{}' gives no value</source>
        <translation>'{}' gibt keinen Wert</translation>
    </message>
    <message>
        <source>the package of &quot;{}&quot; is not known</source>
        <translation>das Paket von „{}“ ist nicht bekannt</translation>
    </message>
    <message>
        <source>the external object '{}' has no value</source>
        <translation>das externe Objekt '{}' hat keinen Wert</translation>
    </message>
    <message>
        <source>at t = {:.6g} s: {}</source>
        <translation>bei t = {:.6g} s: {}</translation>
    </message>
    <message>
        <source>'{}' has no value</source>
        <translation>'{}' hat keinen Wert</translation>
    </message>
    <message>
        <source>the discrete quantities find no rest: '{}' keeps switching</source>
        <translation>die diskreten Größen kommen nicht zur Ruhe: '{}' schaltet weiter</translation>
    </message>
    <message>
        <source>'sample' begins at {} s with an interval of {} s: it needs a number and an interval above 0</source>
        <translation>„sample“ beginnt bei {} s mit einem Abstand von {} s: nötig sind eine Zahl und ein Abstand über 0</translation>
    </message>
    <message>
        <source>at t = {:.6g} s: '{}' has no value: the subscript {} is outside 1:{}</source>
        <translation>bei t = {:.6g} s: „{}“ hat keinen Wert: der Index {} liegt außerhalb von 1:{}</translation>
    </message>
    <message>
        <source>reinit: '{}' is no state of the model</source>
        <translation>reinit: '{}' ist kein Zustand des Modells</translation>
    </message>
    <message>
        <source>reinit a variable that is differentiated, and that no equation ties to another state</source>
        <translation>reinit auf eine Variable anwenden, die abgeleitet wird und die keine Gleichung an einen anderen Zustand bindet</translation>
    </message>
    <message>
        <source>the equations leave '{}' open, and '{}' depends on it</source>
        <translation>die Gleichungen lassen '{}' offen, und '{}' hängt davon ab</translation>
    </message>
    <message>
        <source>the equations leave {} open for a time, since they repeat each other: the smallest values are taken</source>
        <translation>die Gleichungen lassen {} zeitweise offen, weil sie einander wiederholen: die kleinsten Werte werden genommen</translation>
    </message>
    <message>
        <source>the model prints to '{}', which is not written: {}</source>
        <translation>das Modell gibt nach '{}' aus, was nicht geschrieben wird: {}</translation>
    </message>
    <message>
        <source>the subscript of '{}' is outside the array</source>
        <translation>der Index von '{}' liegt außerhalb des Feldes</translation>
    </message>
    <message>
        <source>'{}' belongs to clocked equations (Modelica 3.6, chapter 16), which are not supported</source>
        <translation>'{}' gehört zu getakteten Gleichungen (Modelica 3.6, Kapitel 16), die nicht unterstützt werden</translation>
    </message>
    <message>
        <source>sample with 'when sample(start, interval) then' and pre(), or with Modelica.Blocks.Discrete</source>
        <translation>tasten Sie mit 'when sample(start, interval) then' und pre() ab, oder mit Modelica.Blocks.Discrete</translation>
    </message>
    <message>
        <source>'{}' belongs to state machines (Modelica 3.6, chapter 17), which are not supported</source>
        <translation>'{}' gehört zu Zustandsautomaten (Modelica 3.6, Kapitel 17), die nicht unterstützt werden</translation>
    </message>
    <message>
        <source>keep the state in a discrete variable that changes in 'when', or draw it with Modelica.StateGraph</source>
        <translation>halten Sie den Zustand in einer diskreten Variablen, die sich in 'when' ändert, oder zeichnen Sie ihn mit Modelica.StateGraph</translation>
    </message>
    <message>
        <source>'{}' belongs to stream connectors (Modelica 3.6, chapter 15), which are not supported</source>
        <translation>'{}' gehört zu Stream-Konnektoren (Modelica 3.6, Kapitel 15), die nicht unterstützt werden</translation>
    </message>
    <message>
        <source>use a potential and a flow variable; Modelica.Thermal.FluidHeatFlow models media so</source>
        <translation>verwenden Sie eine Potential- und eine Flussvariable; so modelliert Modelica.Thermal.FluidHeatFlow Medien</translation>
    </message>
    <message>
        <source>where the transport takes a constant time T, delay(u, T) does the same</source>
        <translation>wo der Transport eine feste Zeit T dauert, leistet delay(u, T) dasselbe</translation>
    </message>
    <message>
        <source>It is neither an input of the model nor the output of a block that only produces a signal.</source>
        <translation>Es ist weder ein Eingang des Modells noch der Ausgang eines Blocks, der nur ein Signal erzeugt.</translation>
    </message>
    <message>
        <source>choose among the variables with --variables, or insist with --interval</source>
        <translation>wählen Sie mit --variables unter den Variablen aus, oder bestehen Sie mit --interval darauf</translation>
    </message>
    <message>
        <source>the results are told every {:.3g} s, not every {:.3g} s: these would be more than {} values</source>
        <translation>die Ergebnisse stehen alle {:.3g} s und nicht alle {:.3g} s: das wären mehr als {} Werte</translation>
    </message>
    <message>
        <source>random numbers follow from the name '{}': under another name they differ</source>
        <translation>Zufallszahlen folgen aus dem Namen '{}': unter einem anderen Namen sind es andere</translation>
    </message>
    <message>
        <source>give the component a seed of its own, as with useAutomaticLocalSeed = false</source>
        <translation>der Komponente einen eigenen Startwert geben, etwa mit useAutomaticLocalSeed = false</translation>
    </message>
    <message>
        <source>what '{}' is changes during the simulation: it cannot be compared</source>
        <translation>was '{}' ist, ändert sich während der Simulation: es lässt sich nicht vergleichen</translation>
    </message>
    <message>
        <source>compare the values instead of their texts</source>
        <translation>die Werte statt ihrer Texte vergleichen</translation>
    </message>
    <message>
        <source>'{}' is no array of values</source>
        <translation>'{}' ist kein Feld von Werten</translation>
    </message>
    <message>
        <source>the model prints: {}</source>
        <translation>das Modell gibt aus: {}</translation>
    </message>
    <message>
        <source>the event finds no end: '{}' keeps switching</source>
        <translation>das Ereignis findet kein Ende: '{}' schaltet weiter</translation>
    </message>
    <message>
        <source>the integration does not go on</source>
        <translation>die Integration kommt nicht weiter</translation>
    </message>
    <message>
        <source>the integration does not go on at '{}'</source>
        <translation>die Integration kommt bei '{}' nicht weiter</translation>
    </message>
    <message>
        <source>more than {} events</source>
        <translation>mehr als {} Ereignisse</translation>
    </message>
    <message>
        <source>pre() needs a variable that changes at events, not '{}'</source>
        <translation>pre() braucht eine Variable, die sich bei Ereignissen ändert, nicht '{}'</translation>
    </message>
    <message>
        <source>'{}' is set by two equations</source>
        <translation>'{}' wird von zwei Gleichungen gesetzt</translation>
    </message>
    <message>
        <source>nothing sets '{}', which changes at events alone</source>
        <translation>nichts setzt '{}', das sich nur bei Ereignissen ändert</translation>
    </message>
    <message>
        <source>an equation that sets it has it alone on one side</source>
        <translation>eine Gleichung, die es setzt, hat es allein auf einer Seite</translation>
    </message>
    <message>
        <source>a model with events needs delays that do not change while it runs</source>
        <translation>ein Modell mit Ereignissen braucht Verzögerungen, die sich im Lauf nicht ändern</translation>
    </message>
    <message>
        <source>use a parameter of at least 0 as the delay time</source>
        <translation>als Verzögerungszeit einen Parameter von mindestens 0 nehmen</translation>
    </message>
    <message>
        <source>delay() cannot decide when 'sample' ticks</source>
        <translation>delay() kann nicht bestimmen, wann 'sample' tickt</translation>
    </message>
    <message>
        <source>the file is no MATLAB file</source>
        <translation>die Datei ist keine MATLAB-Datei</translation>
    </message>
    <message>
        <source>when equations are not supported</source>
        <translation>when-Gleichungen werden nicht unterstützt</translation>
    </message>
    <message>
        <source>a relation outside noEvent already is an event: write the equation with if</source>
        <translation>ein Vergleich außerhalb von noEvent ist schon ein Ereignis: die Gleichung mit if schreiben</translation>
    </message>
    <message>
        <source>to close &quot;{}&quot;</source>
        <translation>zum Schließen von „{}“</translation>
    </message>
    <message>
        <source>&quot;{}&quot; behind &quot;end&quot;</source>
        <translation>„{}“ hinter „end“</translation>
    </message>
    <message>
        <source>the innermost open block is &quot;{}&quot;</source>
        <translation>der innerste offene Block ist „{}“</translation>
    </message>
    <message>
        <source>&quot;:=&quot; is an assignment of an algorithm</source>
        <translation>„:=“ ist eine Zuweisung eines Algorithmus</translation>
    </message>
    <message>
        <source>an equation is written with &quot;=&quot;</source>
        <translation>eine Gleichung wird mit „=“ geschrieben</translation>
    </message>
    <message>
        <source>&quot;==&quot; compares; an equation is written with &quot;=&quot;</source>
        <translation>„==“ vergleicht; eine Gleichung wird mit „=“ geschrieben</translation>
    </message>
    <message>
        <source>a declaration cannot stand in the equation section</source>
        <translation>eine Deklaration kann nicht im Abschnitt der Gleichungen stehen</translation>
    </message>
    <message>
        <source>move it before &quot;equation&quot;, or write an equation &quot;left = right&quot;</source>
        <translation>sie vor „equation“ setzen oder eine Gleichung „links = rechts“ schreiben</translation>
    </message>
    <message>
        <source>&quot;=&quot; in the equation</source>
        <translation>„=“ in der Gleichung</translation>
    </message>
    <message>
        <source>the equation</source>
        <translation>der Gleichung</translation>
    </message>
    <message>
        <source>the name of an iterator</source>
        <translation>der Name eines Laufindex</translation>
    </message>
    <message>
        <source>behind the condition</source>
        <translation>hinter der Bedingung</translation>
    </message>
    <message>
        <source>behind the iterator</source>
        <translation>hinter dem Laufindex</translation>
    </message>
    <message>
        <source>behind the range</source>
        <translation>hinter dem Bereich</translation>
    </message>
    <message>
        <source>behind &quot;connect&quot;</source>
        <translation>hinter „connect“</translation>
    </message>
    <message>
        <source>between the two connectors</source>
        <translation>zwischen den beiden Konnektoren</translation>
    </message>
    <message>
        <source>connect(a.port, b.port)</source>
        <translation>connect(a.port, b.port)</translation>
    </message>
    <message>
        <source>behind the two connectors</source>
        <translation>hinter den beiden Konnektoren</translation>
    </message>
    <message>
        <source>connect joins exactly two; chain more of them pairwise</source>
        <translation>connect verbindet genau zwei; mehrere paarweise verketten</translation>
    </message>
    <message>
        <source>a chain of {} operands that mixes scalar and element-wise operators</source>
        <translation>eine Kette von {} Operanden, die skalare und elementweise Operatoren mischt</translation>
    </message>
    <message>
        <source>group it with parentheses</source>
        <translation>sie mit Klammern gliedern</translation>
    </message>
    <message>
        <source>a relation cannot be compared again</source>
        <translation>ein Vergleich kann nicht noch einmal verglichen werden</translation>
    </message>
    <message>
        <source>write &quot;a &lt; b and b &lt; c&quot;</source>
        <translation>„a &lt; b and b &lt; c“ schreiben</translation>
    </message>
    <message>
        <source>a power of a power needs parentheses</source>
        <translation>eine Potenz einer Potenz braucht Klammern</translation>
    </message>
    <message>
        <source>write (a^b)^c or a^(b^c)</source>
        <translation>(a^b)^c oder a^(b^c) schreiben</translation>
    </message>
    <message>
        <source>two operators follow each other: &quot;{}&quot;</source>
        <translation>zwei Operatoren folgen aufeinander: „{}“</translation>
    </message>
    <message>
        <source>put the signed operand in parentheses: a*(-b)</source>
        <translation>den Operanden mit Vorzeichen in Klammern setzen: a*(-b)</translation>
    </message>
    <message>
        <source>an if expression within an expression needs parentheses</source>
        <translation>ein if-Ausdruck in einem Ausdruck braucht Klammern</translation>
    </message>
    <message>
        <source>write a + (if b then c else d)</source>
        <translation>a + (if b then c else d) schreiben</translation>
    </message>
    <message>
        <source>&quot;break&quot; is not supported</source>
        <translation>„break“ wird nicht unterstützt</translation>
    </message>
    <message>
        <source>give the value itself</source>
        <translation>den Wert selbst angeben</translation>
    </message>
    <message>
        <source>functions as arguments are not supported</source>
        <translation>Funktionen als Argumente werden nicht unterstützt</translation>
    </message>
    <message>
        <source>write the relation as equations</source>
        <translation>die Beziehung als Gleichungen schreiben</translation>
    </message>
    <message>
        <source>an expression</source>
        <translation>ein Ausdruck</translation>
    </message>
    <message>
        <source>the number is too large</source>
        <translation>die Zahl ist zu groß</translation>
    </message>
    <message>
        <source>the largest is about 1.8e308</source>
        <translation>die größte ist etwa 1,8e308</translation>
    </message>
    <message>
        <source>unknown escape in a string</source>
        <translation>unbekannte Escape-Folge in einer Zeichenkette</translation>
    </message>
    <message>
        <source>a backslash itself is written \\</source>
        <translation>ein Rückstrich selbst wird \\ geschrieben</translation>
    </message>
    <message>
        <source>an empty array</source>
        <translation>ein leeres Feld</translation>
    </message>
    <message>
        <source>write fill(0.0, 0) or leave the array away</source>
        <translation>fill(0.0, 0) schreiben oder das Feld weglassen</translation>
    </message>
    <message>
        <source>&quot;(&quot; behind &quot;{}&quot;</source>
        <translation>„(“ hinter „{}“</translation>
    </message>
    <message>
        <source>to close the arguments of &quot;{}&quot;</source>
        <translation>zum Schließen der Argumente von „{}“</translation>
    </message>
    <message>
        <source>a positional argument behind a named one</source>
        <translation>ein Argument ohne Namen hinter einem mit Namen</translation>
    </message>
    <message>
        <source>give it a name as well</source>
        <translation>auch ihm einen Namen geben</translation>
    </message>
    <message>
        <source>a name</source>
        <translation>ein Name</translation>
    </message>
    <message>
        <source>at the start of an if expression</source>
        <translation>am Anfang eines if-Ausdrucks</translation>
    </message>
    <message>
        <source>in an if expression</source>
        <translation>in einem if-Ausdruck</translation>
    </message>
    <message>
        <source>to close the parenthesis</source>
        <translation>zum Schließen der Klammer</translation>
    </message>
    <message>
        <source>to close the array</source>
        <translation>zum Schließen des Feldes</translation>
    </message>
    <message>
        <source>to close the matrix</source>
        <translation>zum Schließen der Matrix</translation>
    </message>
    <message>
        <source>to close the subscripts</source>
        <translation>zum Schließen der Indizes</translation>
    </message>
    <message>
        <source>an if expression needs a value for every case</source>
        <translation>ein if-Ausdruck braucht für jeden Fall einen Wert</translation>
    </message>
    <message>
        <source>inherit a class without the element instead</source>
        <translation>stattdessen eine Klasse ohne das Element erben</translation>
    </message>
    <message>
        <source>a modification</source>
        <translation>eine Modifikation</translation>
    </message>
    <message>
        <source>&quot;each&quot; stands before &quot;final&quot;</source>
        <translation>„each“ steht vor „final“</translation>
    </message>
    <message>
        <source>a modification cannot name one element of an array</source>
        <translation>eine Modifikation kann nicht ein einzelnes Element eines Feldes nennen</translation>
    </message>
    <message>
        <source>modify the whole array: x(start={{1, 2, 3}})</source>
        <translation>das ganze Feld modifizieren: x(start={{1, 2, 3}})</translation>
    </message>
    <message>
        <source>a redeclared class is given as &quot;M = Other&quot;</source>
        <translation>eine redeklarierte Klasse wird als „M = Andere“ angegeben</translation>
    </message>
    <message>
        <source>a string behind &quot;+&quot;</source>
        <translation>eine Zeichenkette hinter „+“</translation>
    </message>
    <message>
        <source>before the modifications</source>
        <translation>vor den Modifikationen</translation>
    </message>
    <message>
        <source>to close the modifications</source>
        <translation>zum Schließen der Modifikationen</translation>
    </message>
    <message>
        <source>write the relation as equations of a block</source>
        <translation>die Beziehung als Gleichungen eines Blocks schreiben</translation>
    </message>
    <message>
        <source>operator classes are not supported</source>
        <translation>Operator-Klassen werden nicht unterstützt</translation>
    </message>
    <message>
        <source>'{}' ({}) has connectors whose variables depend on each other ({}, with an equalityConstraint): overconstrained connections are not supported</source>
        <translation>„{}“ ({}) hat Anschlüsse, deren Variablen voneinander abhängen ({}, mit equalityConstraint): überbestimmte Verbindungen werden nicht unterstützt</translation>
    </message>
    <message>
        <source>Use components whose connectors have potentials and flows alone.</source>
        <translation>Komponenten verwenden, deren Anschlüsse nur Potentiale und Flüsse haben.</translation>
    </message>
    <message>
        <source>Model what moves along one axis: a gravity about it is {} ({}), an arm an inertia.</source>
        <translation>Modellieren, was sich um eine Achse bewegt: Die Schwerkraft um sie ist {} ({}), ein Arm eine Trägheit.</translation>
    </message>
    <message>
        <source>nothing is connected to '{}', a signal of an expandable connector</source>
        <translation>nichts ist mit „{}“ verbunden, einem Signal eines erweiterbaren Konnektors</translation>
    </message>
    <message>
        <source>connect it to an output</source>
        <translation>mit einem Ausgang verbinden</translation>
    </message>
    <message>
        <source>initial algorithm sections are not supported</source>
        <translation>Abschnitte „initial algorithm“ werden nicht unterstützt</translation>
    </message>
    <message>
        <source>algorithm sections are not supported</source>
        <translation>Abschnitte „algorithm“ werden nicht unterstützt</translation>
    </message>
    <message>
        <source>write the relations as equations</source>
        <translation>die Beziehungen als Gleichungen schreiben</translation>
    </message>
    <message>
        <source>external functions are not supported</source>
        <translation>externe Funktionen werden nicht unterstützt</translation>
    </message>
    <message>
        <source>'cardinality' takes one connector</source>
        <translation>'cardinality' nimmt einen Konnektor</translation>
    </message>
    <message>
        <source>'cardinality' can stand in equations and their conditions alone</source>
        <translation>'cardinality' kann nur in Gleichungen und ihren Bedingungen stehen</translation>
    </message>
    <message>
        <source>where no connection depends on it</source>
        <translation>wo keine Verbindung davon abhängt</translation>
    </message>
    <message>
        <source>the outer component '{}' cannot be modified: it is the one of an instance around it</source>
        <translation>die äußere Komponente „{}“ lässt sich nicht ändern: sie ist die einer umgebenden Instanz</translation>
    </message>
    <message>
        <source>modify the inner component</source>
        <translation>die innere Komponente ändern</translation>
    </message>
    <message>
        <source>the outer component '{}' of {} has no inner one around it</source>
        <translation>für die äußere Komponente „{}“ von {} gibt es ringsum keine innere</translation>
    </message>
    <message>
        <source>declare it in a model that holds this one: inner {} {}</source>
        <translation>sie in einem Modell deklarieren, das dieses enthält: inner {} {}</translation>
    </message>
    <message>
        <source>the text has {} bytes; at most {} are read</source>
        <translation>der Text hat {} Bytes; höchstens {} werden gelesen</translation>
    </message>
    <message>
        <source>the text is encoded as UTF-16</source>
        <translation>der Text ist als UTF-16 codiert</translation>
    </message>
    <message>
        <source>save the file as UTF-8</source>
        <translation>die Datei als UTF-8 speichern</translation>
    </message>
    <message>
        <source>a zero byte: this is not a Modelica text</source>
        <translation>ein Nullbyte: Das ist kein Modelica-Text</translation>
    </message>
    <message>
        <source>the byte 0x{:02x} is not valid UTF-8</source>
        <translation>das Byte 0x{} ist kein gültiges UTF-8</translation>
    </message>
    <message>
        <source>a Modelica text is stored as UTF-8; is this a Modelica file?</source>
        <translation>ein Modelica-Text wird als UTF-8 gespeichert; ist das eine Modelica-Datei?</translation>
    </message>
    <message>
        <source>the comment is not closed</source>
        <translation>der Kommentar ist nicht abgeschlossen</translation>
    </message>
    <message>
        <source>a comment that begins with /* ends with */</source>
        <translation>ein Kommentar, der mit /* beginnt, endet mit */</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is neither a number nor a name</source>
        <translation>„{}“ ist weder eine Zahl noch ein Name</translation>
    </message>
    <message>
        <source>a name begins with a letter; a product is written with *</source>
        <translation>ein Name beginnt mit einem Buchstaben; ein Produkt wird mit * geschrieben</translation>
    </message>
    <message>
        <source>a number needs a digit before the point</source>
        <translation>eine Zahl braucht eine Ziffer vor dem Punkt</translation>
    </message>
    <message>
        <source>write 0{}</source>
        <translation>0{} schreiben</translation>
    </message>
    <message>
        <source>the string is not closed</source>
        <translation>die Zeichenkette ist nicht abgeschlossen</translation>
    </message>
    <message>
        <source>the quoted name is not closed</source>
        <translation>der Name in Hochkommas ist nicht abgeschlossen</translation>
    </message>
    <message>
        <source>it ends with {}</source>
        <translation>der Abschluss ist {}</translation>
    </message>
    <message>
        <source>the quoted name is empty</source>
        <translation>der Name in Hochkommas ist leer</translation>
    </message>
    <message>
        <source>the control character 0x{:02x} has no meaning here</source>
        <translation>das Steuerzeichen 0x{} hat hier keine Bedeutung</translation>
    </message>
    <message>
        <source>the character {} has no meaning here</source>
        <translation>das Zeichen {} hat hier keine Bedeutung</translation>
    </message>
    <message>
        <source>names hold ASCII letters, digits and _; others stand in quotes: 'T_α'</source>
        <translation>Namen bestehen aus ASCII-Buchstaben, Ziffern und _; andere stehen in Hochkommas: 'T_α'</translation>
    </message>
    <message>
        <source>explains the residual best and passes every check</source>
        <translation>erklärt den Rest am besten und besteht jede Prüfung</translation>
    </message>
    <message>
        <source>explains it as well: this data cannot tell it from the chosen one</source>
        <translation>erklärt ihn ebenso: Diese Daten unterscheiden beide nicht</translation>
    </message>
    <message>
        <source>explains part of it, less than the chosen one</source>
        <translation>erklärt einen Teil davon, weniger als der gewählte</translation>
    </message>
    <message>
        <source>gains no more than chance would</source>
        <translation>bringt nicht mehr als der Zufall</translation>
    </message>
    <message>
        <source>the data cannot show it: it only shifts parameters</source>
        <translation>die Daten können es nicht zeigen: Es verschiebt nur Parameter</translation>
    </message>
    <message>
        <source>the data cannot show it: it only shifts {}</source>
        <translation>die Daten können es nicht zeigen: Es verschiebt nur {}</translation>
    </message>
    <message>
        <source>would need a strength of the wrong physical sign</source>
        <translation>seine Stärke hätte das physikalisch falsche Vorzeichen</translation>
    </message>
    <message>
        <source>does not predict the parts of the data that were left out</source>
        <translation>sagt die ausgelassenen Teile der Daten nicht voraus</translation>
    </message>
    <message>
        <source>could not be simulated or fitted</source>
        <translation>ließ sich nicht simulieren oder anpassen</translation>
    </message>
    <message>
        <source>does not lower the error by more than chance may: evidence {:.3g}, and {:.3g} is asked for</source>
        <translation>senkt den Fehler nicht mehr, als Zufall es kann: Evidenz {}, verlangt sind {}</translation>
    </message>
    <message>
        <source>what it explains lies right behind changes of an input, and how that ran between its samples may be all there is to it</source>
        <translation>was er erklärt, liegt gleich hinter Änderungen eines Eingangs, und wie der zwischen seinen Abtastwerten lief, kann schon alles sein</translation>
    </message>
    <message>
        <source>held-out blocks contradict it: they bear out {:.0f} % of what it explains, and more than {:.0f} % is asked for</source>
        <translation>ausgelassene Abschnitte widersprechen: Sie bestätigen {} % dessen, was er erklärt, verlangt sind mehr als {} %</translation>
    </message>
    <message>
        <source>explains {:.2g} % of what stays unexplained beside it, which is too little to count</source>
        <translation>erklärt {} % dessen, was daneben unerklärt bleibt; das ist zu wenig</translation>
    </message>
    <message>
        <source>could not be tried: {}</source>
        <translation>ließ sich nicht erproben: {}</translation>
    </message>
    <message>
        <source>explains nothing of what is left</source>
        <translation>erklärt nichts von dem, was übrig ist</translation>
    </message>
    <message>
        <source>promises no more than chance may bring (score {:.3g}), and was not refitted</source>
        <translation>verspricht nicht mehr, als Zufall bringen kann (Wert {}), und wurde nicht angepasst</translation>
    </message>
    <message>
        <source>others promise more and were refitted instead (score {:.3g})</source>
        <translation>andere versprechen mehr und wurden statt seiner angepasst (Wert {})</translation>
    </message>
    <message>
        <source>its strength, or what shapes it, rests at a bound: it stands for something else</source>
        <translation>seine Stärke oder seine Form liegt an einer Grenze: Er steht für etwas anderes</translation>
    </message>
    <message>
        <source>its strength is not distinguishable from 0</source>
        <translation>seine Stärke ist von 0 nicht zu unterscheiden</translation>
    </message>
    <message>
        <source>what was left out is not predicted clearly better with it: the error goes from {:.3g} to {:.3g} %, lower in {} of {} parts</source>
        <translation>was weggelassen wurde, wird damit nicht deutlich besser vorausgesagt: Der Fehler geht von {:.3g} auf {:.3g} %, kleiner in {} von {} Teilen</translation>
    </message>
    <message>
        <source>with {} in its place the model predicts nearly as well: what is stored comes late, too</source>
        <translation>mit {} an seiner Stelle sagt das Modell fast so gut voraus: Was gespeichert wird, kommt ebenfalls später</translation>
    </message>
    <message>
        <source>'{}': with {} there, where the fitted recordings say {:.4g}, the model misses it by {:.0f} % less: the component may be another one, or something around it that was not recorded</source>
        <translation>„{}“: Mit {} dort, wo die angepassten Aufzeichnungen {:.4g} sagen, verfehlt das Modell sie um {:.0f} % weniger: Das Bauteil mag ein anderes sein, oder etwas um es herum, das nicht aufgezeichnet wurde</translation>
    </message>
    <message>
        <source>{}; {} does nearly as well</source>
        <translation>{}; {} leistet fast ebenso viel</translation>
    </message>
    <message>
        <source>indicated: structure remains, but beside a flow that nobody measured it is far likelier than that flow alone and than any other name; the error of what was left out of the fit goes from {} to {}</source>
        <translation>angezeigt: Struktur bleibt, aber neben einem Fluss, den niemand gemessen hat, ist er weit wahrscheinlicher als dieser Fluss allein und als jeder andere Name; der Fehler dessen, was aus der Anpassung weggelassen wurde, geht von {} auf {}</translation>
    </message>
    <message>
        <source>less likely than {} beside a flow that nobody measured</source>
        <translation>weniger wahrscheinlich als {} neben einem Fluss, den niemand gemessen hat</translation>
    </message>
    <message>
        <source>predicts less well what was left out than {}</source>
        <translation>sagt weniger gut voraus, was weggelassen wurde, als {}</translation>
    </message>
    <message>
        <source>established: neither noise nor a disturbance accounts for it</source>
        <translation>erwiesen: Weder Rauschen noch eine Störung erklärt es</translation>
    </message>
    <message>
        <source>indicated: the search ended before its last tests</source>
        <translation>angezeigt: Die Suche endete vor ihren letzten Prüfungen</translation>
    </message>
    <message>
        <source>What remains behaves like a flow of {} {} (root mean square) at {} that nobody measured, and that changes within about {} s.</source>
        <translation>Was bleibt, verhält sich wie ein Strom von {} {} (Effektivwert) bei {}, den niemand gemessen hat und der sich innerhalb von etwa {} s ändert.</translation>
    </message>
    <message>
        <source>indicated: structure remains, but with it the error of what was left out of the fit falls from {} to {}, in {} of {} parts</source>
        <translation>angezeigt: Struktur bleibt, aber damit fällt der Fehler dessen, was aus der Anpassung weggelassen wurde, von {} auf {}, in {} von {} Teilen</translation>
    </message>
    <message>
        <source>grows against an effect of the model: two that cancel explain what neither does</source>
        <translation>wächst gegen einen Effekt des Modells an: Zwei, die sich aufheben, erklären, was keiner tut</translation>
    </message>
    <message>
        <source>explains little against what is left beside it</source>
        <translation>erklärt wenig gegen das, was daneben bleibt</translation>
    </message>
    <message>
        <source>a flow that nobody measured, and that varies slowly, accounts for as much</source>
        <translation>ein langsam veränderlicher Fluss, den niemand gemessen hat, erklärt ebenso viel</translation>
    </message>
    <message>
        <source>its form may follow what other effects do, and with it structure remains</source>
        <translation>seine Form kann dem folgen, was andere Effekte tun, und mit ihm bleibt Struktur</translation>
    </message>
    <message>
        <source>taken out again: {}</source>
        <translation>wieder herausgenommen: {}</translation>
    </message>
    <message>
        <source>explains less than {}</source>
        <translation>erklärt weniger als {}</translation>
    </message>
    <message>
        <source>{}, an equation without a name, is the better account</source>
        <translation>{}, eine Gleichung ohne Namen, erklärt es besser</translation>
    </message>
    <message>
        <source>an equation without a name, and not clearly a better account than {}</source>
        <translation>eine Gleichung ohne Namen, die es nicht deutlich besser erklärt als {}</translation>
    </message>
    <message>
        <source>{} explains nearly as much with fewer parameters</source>
        <translation>{} erklärt fast so viel mit weniger Parametern</translation>
    </message>
    <message>
        <source>{} explains nearly as much, and is met more often</source>
        <translation>{} erklärt fast so viel und kommt öfter vor</translation>
    </message>
    <message>
        <source>no fit with it could begin</source>
        <translation>keine Anpassung damit konnte beginnen</translation>
    </message>
    <message>
        <source>could not be fitted: {}</source>
        <translation>ließ sich nicht anpassen: {}</translation>
    </message>
    <message>
        <source>the data cannot tell it from {}</source>
        <translation>die Daten unterscheiden es nicht von {}</translation>
    </message>
    <message>
        <source>explains less together with another than the pair with which the search began</source>
        <translation>erklärt mit einem anderen zusammen weniger als das Paar, mit dem die Suche begann</translation>
    </message>
    <message>
        <source>was not kept to the end of the search</source>
        <translation>blieb nicht bis zum Ende der Suche</translation>
    </message>
    <message>
        <source>is no equal of anything that was kept: {}</source>
        <translation>kommt keinem gleich, der blieb: {}</translation>
    </message>
    <message>
        <source>explains no more than the forms of the effects that were found may be wrong by</source>
        <translation>erklärt nicht mehr, als die Formen der gefundenen Effekte ungenau sein können</translation>
    </message>
    <message>
        <source>the search came to a better end from {}</source>
        <translation>die Suche kam von {} aus zu einem besseren Ende</translation>
    </message>
    <message>
        <source>what is left is noise with a memory, and this explains too little of it</source>
        <translation>was übrig ist, ist Rauschen mit Gedächtnis, und dies erklärt zu wenig davon</translation>
    </message>
    <message>
        <source>an equation without a name explains more in its place</source>
        <translation>eine Gleichung ohne Namen erklärt an seiner Stelle mehr</translation>
    </message>
    <message>
        <source>{} and {} explain more in place of both</source>
        <translation>{} und {} erklären an der Stelle beider mehr</translation>
    </message>
    <message>
        <source>beside the other effects {} explains more in its place</source>
        <translation>neben den anderen Effekten erklärt {} an seiner Stelle mehr</translation>
    </message>
    <message>
        <source>with it a parameter of the model rests at a bound: it does the work of what is known to be there</source>
        <translation>mit ihm liegt ein Parameter des Modells an einer Grenze: Er tut die Arbeit dessen, was bekanntermaßen da ist</translation>
    </message>
    <message>
        <source>on all samples instead of means of them: {}</source>
        <translation>auf allen Abtastwerten statt auf ihren Mitteln: {}</translation>
    </message>
    <message>
        <source>set aside behind an equation without a name that was chosen before it</source>
        <translation>zurückgestellt hinter eine Gleichung ohne Namen, die vor ihm gewählt war</translation>
    </message>
    <message>
        <source>leaves far more than an equation without a name</source>
        <translation>lässt weit mehr übrig als eine Gleichung ohne Namen</translation>
    </message>
    <message>
        <source>another value of {} is the better account</source>
        <translation>ein anderer Wert von {} erklärt es besser</translation>
    </message>
    <message>
        <source>the traces are long and were not written, since the run was interrupted</source>
        <translation>die Verläufe sind lang und wurden nicht geschrieben, da der Lauf abgebrochen wurde</translation>
    </message>
    <message>
        <source>the search was stopped before it was borne out</source>
        <translation>die Suche wurde beendet, bevor er bestätigt war</translation>
    </message>
    <message>
        <source>of several effects that explain much together none is missed: they only imitate it</source>
        <translation>von mehreren Effekten, die zusammen viel erklären, fehlt keiner sehr: Sie ahmen es nur nach</translation>
    </message>
    <message>
        <source>{} that changes in mid run is the better account</source>
        <translation>{}, das sich mitten im Lauf ändert, erklärt es besser</translation>
    </message>
    <message>
        <source>{} that moves with a recorded channel is the better account</source>
        <translation>{}, das sich mit einem aufgezeichneten Kanal bewegt, erklärt es besser</translation>
    </message>
    <message>
        <source>'{}' begins in motion: the model of output '{}' begins at rest and has caught up at {:.5g} s</source>
        <translation>„{}“ beginnt in Bewegung: Das Modell des Ausgangs „{}“ beginnt in Ruhe und hat bei {} s aufgeholt</translation>
    </message>
    <message>
        <source>output '{}' of '{}' reads exactly the same from {:.5g} s to {:.5g} s and jumps when it goes on: the sensor or the logger stuck</source>
        <translation>Ausgang „{}“ von „{}“ zeigt von {} s bis {} s genau dasselbe und springt, wenn er weitergeht: Der Sensor oder der Logger hing</translation>
    </message>
    <message>
        <source>output '{}' of '{}' reads exactly the same from {:.5g} s to its end, where the model moves on: the sensor or the logger stuck</source>
        <translation>Ausgang „{}“ von „{}“ zeigt von {} s bis zum Ende genau dasselbe, während das Modell sich weiter bewegt: Der Sensor oder der Logger hing</translation>
    </message>
    <message>
        <source>output '{}' of '{}': single samples far from their neighbours and from the model are taken for faults of the measurement ({} of them: {})</source>
        <translation>Ausgang „{}“ von „{}“: Einzelne Abtastwerte weitab von ihren Nachbarn und vom Modell gelten als Fehler der Messung ({}: {})</translation>
    </message>
    <message>
        <source>{}; these samples are left out</source>
        <translation>{}; diese Abtastwerte bleiben außer Betracht</translation>
    </message>
    <message>
        <source>{}; the error that is reported of '{}' is over all samples, {:.3g} %: without those at fault it is {:.3g} %</source>
        <translation>{}; der berichtete Fehler von „{}“ ist der über alle Abtastwerte, {} %: Ohne die fehlerhaften ist er {} %</translation>
    </message>
    <message>
        <source>{} in '{}'</source>
        <translation>{} in „{}“</translation>
    </message>
    <message>
        <source>the numbers of {} look like {} and not like the {} that is told</source>
        <translation>die Zahlen von {} sehen nach {} aus und nicht nach {}, wie angegeben</translation>
    </message>
    <message>
        <source>the numbers of {} look like {} (or {}: other parameters make up for it) and not like the {} that is told</source>
        <translation>die Zahlen von {} sehen nach {} aus (oder nach {}: andere Parameter gleichen es aus) und nicht nach {}, wie angegeben</translation>
    </message>
    <message>
        <source>{} seems to be recorded with the wrong sign</source>
        <translation>{} ist anscheinend mit falschem Vorzeichen aufgezeichnet</translation>
    </message>
    <message>
        <source>{} seems to be recorded with the wrong sign in '{}'</source>
        <translation>{} ist in „{}“ anscheinend mit falschem Vorzeichen aufgezeichnet</translation>
    </message>
    <message>
        <source>{} and {} seem to be exchanged</source>
        <translation>{} und {} sind anscheinend vertauscht</translation>
    </message>
    <message>
        <source>{} and {} seem to be exchanged in '{}'</source>
        <translation>{} und {} sind in „{}“ anscheinend vertauscht</translation>
    </message>
    <message>
        <source>{}, or {} (the data do not tell which)</source>
        <translation>{}, oder {} (was davon, sagen die Daten nicht)</translation>
    </message>
    <message>
        <source>{}: {}; give the column &quot;scale&quot;: -1 in the study, and search again</source>
        <translation>{}: {}; der Spalte in der Studie &quot;scale&quot;: -1 geben und noch einmal suchen</translation>
    </message>
    <message>
        <source>{}: {}; give each channel the other's column in the study, and search again</source>
        <translation>{}: {}; jedem Kanal in der Studie die Spalte des anderen geben und noch einmal suchen</translation>
    </message>
    <message>
        <source>read so, the model as it is leaves an error of {:.3g} % instead of {:.3g} %</source>
        <translation>so gelesen lässt das Modell, wie es ist, einen Fehler von {} % statt {} %</translation>
    </message>
    <message>
        <source>, and of {:.3g} % instead of {:.3g} % on recordings that were not fitted</source>
        <translation>, und von {} % statt {} % auf Aufzeichnungen, die nicht angepasst wurden</translation>
    </message>
    <message>
        <source>{}: {}; correct the header, or give the unit in the study, and search again</source>
        <translation>{}: {}; die Kopfzeile berichtigen oder die Einheit in der Studie angeben und noch einmal suchen</translation>
    </message>
    <message>
        <source>{} = {:.4g}{}</source>
        <translation>{} = {}{}</translation>
    </message>
    <message>
        <source>{} = {:.5g}{}</source>
        <translation>{} = {}{}</translation>
    </message>
    <message>
        <source>{} = {:.5g}</source>
        <translation>{} = {}</translation>
    </message>
    <message>
        <source>{:.5g} s</source>
        <translation>{} s</translation>
    </message>
    <message>
        <source>{:.3g}{}</source>
        <translation>{}{}</translation>
    </message>
    <message>
        <source>no measurement was given</source>
        <translation>es wurde keine Messung angegeben</translation>
    </message>
    <message>
        <source>no column of the measurement can be the time</source>
        <translation>keine Spalte der Messung kann die Zeit sein</translation>
    </message>
    <message>
        <source>Its values must rise from row to row: name one 't [s]'.</source>
        <translation>Ihre Werte müssen von Zeile zu Zeile steigen: eine „t [s]“ nennen.</translation>
    </message>
    <message>
        <source>the time column '{}' has no unit in its header</source>
        <translation>die Zeitspalte „{}“ hat keine Einheit in ihrer Kopfzeile</translation>
    </message>
    <message>
        <source>Write it as '{} [{}]': a time without a unit is read in seconds.</source>
        <translation>Als „{} [{}]“ schreiben: Eine Zeit ohne Einheit wird in Sekunden gelesen.</translation>
    </message>
    <message>
        <source>'{}' is the time.</source>
        <translation>„{}“ ist die Zeit.</translation>
    </message>
    <message>
        <source>no domain was given</source>
        <translation>es wurde keine Domäne angegeben</translation>
    </message>
    <message>
        <source>Known are: {}.</source>
        <translation>Bekannt sind: {}.</translation>
    </message>
    <message>
        <source>no connector joins {} to the rest of the chain</source>
        <translation>kein Anschluss verbindet {} mit dem Rest der Kette</translation>
    </message>
    <message>
        <source>A domain that both have in common is missing between them.</source>
        <translation>Zwischen ihnen fehlt eine Domäne, die beide gemeinsam haben.</translation>
    </message>
    <message>
        <source>{} and {} are joined by {} and {}.</source>
        <translation>{} und {} sind über {} und {} verbunden.</translation>
    </message>
    <message>
        <source>{} is compared with '{}'.</source>
        <translation>{} wird mit „{}“ verglichen.</translation>
    </message>
    <message>
        <source>nothing is known that could drive {} [{}]</source>
        <translation>es ist nichts bekannt, das {} [{}] speisen könnte</translation>
    </message>
    <message>
        <source>{} gets the same voltage.</source>
        <translation>{} erhält dieselbe Spannung.</translation>
    </message>
    <message>
        <source>{} drives {}.</source>
        <translation>{} treibt {}.</translation>
    </message>
    <message>
        <source>no column can drive {}: a voltage [V] is needed</source>
        <translation>keine Spalte kann {} speisen: Nötig ist eine Spannung [V]</translation>
    </message>
    <message>
        <source>Give the column a unit in its header, as 'u [V]'.</source>
        <translation>Der Spalte in der Kopfzeile eine Einheit geben, etwa „u [V]“.</translation>
    </message>
    <message>
        <source>{} switches a supply of {:.3g} V to {}.</source>
        <translation>{} schaltet eine Versorgung von {} V auf {}.</translation>
    </message>
    <message>
        <source>{} is left free: no torque acts on it.</source>
        <translation>{} bleibt frei: Kein Drehmoment wirkt darauf.</translation>
    </message>
    <message>
        <source>An inertia turns with {}: the basic class of a motor has none.</source>
        <translation>Mit {} dreht sich eine Trägheit: Die Grundklasse eines Motors hat keine.</translation>
    </message>
    <message>
        <source>A load that grows with the square of the speed (pump, fan) hangs on {}.</source>
        <translation>An {} hängt eine Last, die mit dem Quadrat der Drehzahl wächst (Pumpe, Lüfter).</translation>
    </message>
    <message>
        <source>{} heats {}.</source>
        <translation>{} heizt {}.</translation>
    </message>
    <message>
        <source>{} is the temperature at {}.</source>
        <translation>{} ist die Temperatur an {}.</translation>
    </message>
    <message>
        <source>The temperature at {} is 293.15 K: no column of the surroundings was found.</source>
        <translation>Die Temperatur an {} ist 293,15 K: Es wurde keine Spalte der Umgebung gefunden.</translation>
    </message>
    <message>
        <source>the measurement has no column that the model could be compared with</source>
        <translation>die Messung hat keine Spalte, mit der das Modell verglichen werden könnte</translation>
    </message>
    <message>
        <source>Wanted is a current [A], a speed [rad/s], an angle [rad] or a temperature [K] that the model does not already take as its input; give the columns their units in the header.</source>
        <translation>Gesucht ist ein Strom [A], eine Drehzahl [rad/s], ein Winkel [rad] oder eine Temperatur [K], die das Modell nicht schon als Eingang erhält; den Spalten in der Kopfzeile ihre Einheiten geben.</translation>
    </message>
    <message>
        <source>{}.L is 0: the inductance is left out until the data call for it.</source>
        <translation>{}.L ist 0: Die Induktivität bleibt weg, bis die Daten sie verlangen.</translation>
    </message>
    <message>
        <source>{0}.J2 is 0 and {0}.r is 1: all inertia is in J1, there is no gear.</source>
        <translation>{0}.J2 ist 0 und {0}.r ist 1: Alle Trägheit steckt in J1, ein Getriebe gibt es nicht.</translation>
    </message>
    <message>
        <source>{0}.A is {1:.3g} m2 and stays: only the product of {0}.A and {0}.c_o shows in the data.</source>
        <translation>{0}.A ist {1} m2 und bleibt so: Nur das Produkt aus {0}.A und {0}.c_o zeigt sich in den Daten.</translation>
    </message>
    <message>
        <source>{} starts at the temperature of its surroundings ('{}').</source>
        <translation>{} beginnt bei der Temperatur der Umgebung („{}“).</translation>
    </message>
    <message>
        <source>{} is fitted from {:.3g} ({}) within {:.3g} … {:.3g}.</source>
        <translation>{} wird angepasst, ausgehend von {} ({}), im Bereich {} … {}.</translation>
    </message>
    <message>
        <source>'{}' is in {}: its header gives no unit, its name does.</source>
        <translation>„{}“ ist in {}: Die Kopfzeile nennt keine Einheit, der Name schon.</translation>
    </message>
    <message>
        <source>The recording up to {:.3g} s is fitted, the rest validates{}.</source>
        <translation>Die Aufzeichnung bis {} s wird angepasst, der Rest validiert{}.</translation>
    </message>
    <message>
        <source>: there it stands as at its beginning</source>
        <translation>: dort steht das Bauteil wie an ihrem Beginn</translation>
    </message>
    <message>
        <source>, although the model starts it at rest and the component does not; a recording of its own for the validation is better</source>
        <translation>, obwohl das Modell dort in Ruhe beginnt und das Bauteil nicht; eine eigene Aufzeichnung zur Validierung ist besser</translation>
    </message>
    <message>
        <source>a usual value</source>
        <translation>ein üblicher Wert</translation>
    </message>
    <message>
        <source>a metal</source>
        <translation>ein Metall</translation>
    </message>
    <message>
        <source>voltage over current</source>
        <translation>Spannung durch Strom</translation>
    </message>
    <message>
        <source>voltage over current where the current is high</source>
        <translation>Spannung durch Strom, wo der Strom groß ist</translation>
    </message>
    <message>
        <source>v = R*i + k*w over the recording</source>
        <translation>v = R*i + k*w über die Aufzeichnung</translation>
    </message>
    <message>
        <source>how fast it follows</source>
        <translation>wie schnell es folgt</translation>
    </message>
    <message>
        <source>torque over the square of the speed</source>
        <translation>Drehmoment durch Quadrat der Drehzahl</translation>
    </message>
    <message>
        <source>torque over speed</source>
        <translation>Drehmoment durch Drehzahl</translation>
    </message>
    <message>
        <source>power over temperature difference</source>
        <translation>Leistung durch Temperaturunterschied</translation>
    </message>
    <message>
        <source>the domain '{}' is not known</source>
        <translation>die Domäne „{}“ ist nicht bekannt</translation>
    </message>
    <message>
        <source>Did you mean '{}'? </source>
        <translation>Ist „{}“ gemeint? </translation>
    </message>
    <message>
        <source>'{}' cannot be the name of a model</source>
        <translation>„{}“ kann nicht der Name eines Modells sein</translation>
    </message>
    <message>
        <source>A name is a letter followed by letters, digits and underscores.</source>
        <translation>Ein Name ist ein Buchstabe, gefolgt von Buchstaben, Ziffern und Unterstrichen.</translation>
    </message>
    <message>
        <source>the disk may be full</source>
        <translation>der Datenträger ist vielleicht voll</translation>
    </message>
    <message>
        <source>an entry has no name</source>
        <translation>ein Eintrag hat keinen Namen</translation>
    </message>
    <message>
        <source>a name has {} bytes, more than {}</source>
        <translation>ein Name hat {} Bytes, mehr als {}</translation>
    </message>
    <message>
        <source>the entry &quot;{}&quot; holds a NUL in its name</source>
        <translation>der Eintrag „{}“ hat ein NUL-Zeichen im Namen</translation>
    </message>
    <message>
        <source>the entry &quot;{}&quot; holds a backslash in its name</source>
        <translation>der Eintrag „{}“ hat einen umgekehrten Schrägstrich im Namen</translation>
    </message>
    <message>
        <source>the entry &quot;{}&quot; has an absolute path</source>
        <translation>der Eintrag „{}“ hat einen absoluten Pfad</translation>
    </message>
    <message>
        <source>the entry &quot;{}&quot; leads out of the archive</source>
        <translation>der Eintrag „{}“ führt aus dem Archiv hinaus</translation>
    </message>
    <message>
        <source>the entry &quot;{}&quot; has an empty part in its path</source>
        <translation>der Eintrag „{}“ hat einen leeren Teil in seinem Pfad</translation>
    </message>
    <message>
        <source>this is no zip archive, or it is cut off</source>
        <translation>dies ist kein Zip-Archiv, oder es ist abgeschnitten</translation>
    </message>
    <message>
        <source>an entry has invisible characters in its name: &quot;{}&quot;</source>
        <translation>ein Eintrag hat unsichtbare Zeichen im Namen: „{}“</translation>
    </message>
    <message>
        <source>Do not trust this file: it was damaged or made by hand.</source>
        <translation>Dieser Datei nicht trauen: Sie wurde beschädigt oder von Hand gemacht.</translation>
    </message>
    <message>
        <source>the archive is split over several files</source>
        <translation>das Archiv ist auf mehrere Dateien verteilt</translation>
    </message>
    <message>
        <source>the archive is in the format for more than 4 GB, which a study does not use</source>
        <translation>das Archiv hat das Format für mehr als 4 GB, das eine Studie nicht verwendet</translation>
    </message>
    <message>
        <source>the list of its entries lies outside the file</source>
        <translation>das Verzeichnis der Einträge liegt außerhalb der Datei</translation>
    </message>
    <message>
        <source>there is data before or between the parts of the archive</source>
        <translation>vor oder zwischen den Teilen des Archivs stehen Daten</translation>
    </message>
    <message>
        <source>the list of its entries is damaged</source>
        <translation>das Verzeichnis der Einträge ist beschädigt</translation>
    </message>
    <message>
        <source>the list of its entries is cut off</source>
        <translation>das Verzeichnis der Einträge ist abgeschnitten</translation>
    </message>
    <message>
        <source>the entry &quot;{}&quot; stands twice</source>
        <translation>der Eintrag „{}“ steht zweimal darin</translation>
    </message>
    <message>
        <source>the entry &quot;{}&quot; is encrypted</source>
        <translation>der Eintrag „{}“ ist verschlüsselt</translation>
    </message>
    <message>
        <source>the entry &quot;{}&quot; is compressed by method {}, which is not known</source>
        <translation>der Eintrag „{}“ ist mit dem Verfahren {} komprimiert, das nicht bekannt ist</translation>
    </message>
    <message>
        <source>the entry &quot;{}&quot; has two different sizes</source>
        <translation>der Eintrag „{}“ hat zwei verschiedene Größen</translation>
    </message>
    <message>
        <source>the list of its entries has data behind its end</source>
        <translation>hinter dem Ende des Verzeichnisses der Einträge stehen Daten</translation>
    </message>
    <message>
        <source>the entry &quot;{}&quot; is not where the list says</source>
        <translation>der Eintrag „{}“ ist nicht dort, wo das Verzeichnis ihn nennt</translation>
    </message>
    <message>
        <source>the entry &quot;{}&quot; has another name at its data</source>
        <translation>der Eintrag „{}“ hat bei seinen Daten einen anderen Namen</translation>
    </message>
    <message>
        <source>the entry &quot;{}&quot; has two different methods of compression</source>
        <translation>der Eintrag „{}“ hat zwei verschiedene Kompressionsverfahren</translation>
    </message>
    <message>
        <source>the data of &quot;{}&quot; is cut off</source>
        <translation>die Daten von „{}“ sind abgeschnitten</translation>
    </message>
    <message>
        <source>entries share their data</source>
        <translation>Einträge teilen sich Daten</translation>
    </message>
    <message>
        <source>there is data before the archive</source>
        <translation>vor dem Archiv stehen Daten</translation>
    </message>
    <message>
        <source>the unit table udunits2.xml could not be read</source>
        <translation>die Einheitentabelle udunits2.xml konnte nicht gelesen werden</translation>
    </message>
    <message>
        <source>install libudunits2-data or set UDUNITS2_XML_PATH</source>
        <translation>libudunits2-data installieren oder UDUNITS2_XML_PATH setzen</translation>
    </message>
    <message>
        <source>unknown unit &quot;{}&quot;</source>
        <translation>unbekannte Einheit „{}“</translation>
    </message>
    <message>
        <source>write it as in &quot;degC&quot;, &quot;rad/s&quot;, &quot;N.m&quot;, &quot;W/(m2.K)&quot;; &quot;1&quot; has no dimension</source>
        <translation>sie schreiben wie in „degC“, „rad/s“, „N.m“, „W/(m2.K)“; „1“ hat keine Dimension</translation>
    </message>
    <message>
        <source>&quot;C&quot; is the coulomb; write &quot;degC&quot; for a temperature</source>
        <translation>„C“ ist das Coulomb; für eine Temperatur „degC“ schreiben</translation>
    </message>
    <message>
        <source>&quot;F&quot; is the farad; write &quot;degF&quot; for a temperature</source>
        <translation>„F“ ist das Farad; für eine Temperatur „degF“ schreiben</translation>
    </message>
    <message>
        <source>state the unit on both sides; &quot;1&quot; says that there is no dimension</source>
        <translation>die Einheit auf beiden Seiten angeben; „1“ besagt, dass es keine Dimension gibt</translation>
    </message>
    <message>
        <source>no unit is given on one side, &quot;{}&quot; on the other</source>
        <translation>auf der einen Seite steht keine Einheit, auf der anderen „{}“</translation>
    </message>
    <message>
        <source>&quot;{}&quot; cannot be converted to &quot;{}&quot;: they measure different quantities</source>
        <translation>„{}“ lässt sich nicht in „{}“ umrechnen: Sie messen verschiedene Größen</translation>
    </message>
    <message>
        <source>there is no class &quot;{}&quot;</source>
        <translation>es gibt keine Klasse „{}“</translation>
    </message>
    <message>
        <source>model {} has no component &quot;{}&quot;</source>
        <translation>Modell {} hat keine Komponente „{}“</translation>
    </message>
    <message>
        <source>removed</source>
        <translation>entfernt</translation>
    </message>
    <message>
        <source>renamed</source>
        <translation>umbenannt</translation>
    </message>
    <message>
        <source>moved</source>
        <translation>verschoben</translation>
    </message>
    <message>
        <source>model {} has no connection of &quot;{}&quot; with &quot;{}&quot;</source>
        <translation>Modell {} hat keine Verbindung von „{}“ mit „{}“</translation>
    </message>
    <message>
        <source>no connection of model {} ends at &quot;{}&quot;</source>
        <translation>keine Verbindung von Modell {} endet an „{}“</translation>
    </message>
    <message>
        <source>an inherited connection can only be changed in the class that holds it</source>
        <translation>eine geerbte Verbindung lässt sich nur in der Klasse ändern, in der sie steht</translation>
    </message>
    <message>
        <source>&quot;{}&quot; of model {} cannot be set: the values of the other elements are not known</source>
        <translation>„{}“ von Modell {} lässt sich nicht setzen: Die Werte der anderen Elemente sind nicht bekannt</translation>
    </message>
    <message>
        <source>set the whole array</source>
        <translation>das ganze Feld setzen</translation>
    </message>
    <message>
        <source>the class of &quot;{}&quot; cannot change in model {}: it is inherited from {}, where it is not replaceable</source>
        <translation>die Klasse von „{}“ kann sich in Modell {} nicht ändern: Sie ist von {} geerbt und dort nicht „replaceable“</translation>
    </message>
    <message>
        <source>declare it as &quot;replaceable&quot; there</source>
        <translation>sie dort als „replaceable“ deklarieren</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is inherited from {} and cannot be {} in model {}</source>
        <translation>„{0}“ ist von {1} geerbt und kann in Modell {3} nicht {2} werden</translation>
    </message>
    <message>
        <source>change the class it comes from</source>
        <translation>die Klasse ändern, aus der es stammt</translation>
    </message>
    <message>
        <source>there is nothing to be grouped</source>
        <translation>es gibt nichts zusammenzufassen</translation>
    </message>
    <message>
        <source>{} is not declared in {} itself</source>
        <translation>{} ist nicht in {} selbst deklariert</translation>
    </message>
    <message>
        <source>{} is a connector of the model and stays outside</source>
        <translation>{} ist ein Anschluss des Modells und bleibt außerhalb</translation>
    </message>
    <message>
        <source>{} refers to {}, which would stay outside</source>
        <translation>{} bezieht sich auf {}, das außerhalb bliebe</translation>
    </message>
    <message>
        <source>write the value itself, or move both</source>
        <translation>den Wert selbst schreiben oder beide zusammenfassen</translation>
    </message>
    <message>
        <source>{} is connected within an if or a for</source>
        <translation>{} ist innerhalb eines if oder for verbunden</translation>
    </message>
    <message>
        <source>{} is no plain connector</source>
        <translation>{} ist kein einfacher Anschluss</translation>
    </message>
    <message>
        <source>leave its block outside</source>
        <translation>seinen Block außerhalb lassen</translation>
    </message>
    <message>
        <source>the components cannot be put into {}</source>
        <translation>die Komponenten lassen sich nicht in {} unterbringen</translation>
    </message>
    <message>
        <source>the class of {} is only known within {}</source>
        <translation>die Klasse von {} ist nur innerhalb von {} bekannt</translation>
    </message>
    <message>
        <source>the effect annotation of {} lacks '{}'</source>
        <translation>der Effekt-Annotation von {} fehlt „{}“</translation>
    </message>
    <message>
        <source>'{}' must be a text in quotes</source>
        <translation>„{}“ muss ein Text in Anführungszeichen sein</translation>
    </message>
    <message>
        <source>'{}' must be true or false</source>
        <translation>„{}“ muss true oder false sein</translation>
    </message>
    <message>
        <source>'{}' must be a number</source>
        <translation>„{}“ muss eine Zahl sein</translation>
    </message>
    <message>
        <source>'{}' must be a list of texts in quotes</source>
        <translation>„{}“ muss eine Liste von Texten in Anführungszeichen sein</translation>
    </message>
    <message>
        <source>'{}' must be a list of texts in braces</source>
        <translation>„{}“ muss eine Liste von Texten in geschweiften Klammern sein</translation>
    </message>
    <message>
        <source>the class takes no part in the search for effects until this is mended</source>
        <translation>die Klasse nimmt an der Suche nach Effekten nicht teil, bis das behoben ist</translation>
    </message>
    <message>
        <source>unknown way '{}' of the effect {}</source>
        <translation>unbekannter Weg „{}“ des Effekts {}</translation>
    </message>
    <message>
        <source>use &quot;attach&quot;, &quot;insert&quot;, &quot;specialise&quot; or &quot;bridge&quot;</source>
        <translation>„attach“, „insert“, „specialise“ oder „bridge“ verwenden</translation>
    </message>
    <message>
        <source>the effect {} names {} connectors, '{}' takes {}</source>
        <translation>der Effekt {} nennt {} Anschlüsse, „{}“ braucht {}</translation>
    </message>
    <message>
        <source>list them as ports = {{&quot;…&quot;}}</source>
        <translation>sie als ports = {{&quot;…&quot;}} aufführen</translation>
    </message>
    <message>
        <source>{} specialises nothing: it inherits from no class</source>
        <translation>{} spezialisiert nichts: Es erbt von keiner Klasse</translation>
    </message>
    <message>
        <source>let it extend the base class of the components it may replace</source>
        <translation>die Basisklasse der Komponenten erweitern lassen, die es ersetzen darf</translation>
    </message>
    <message>
        <source>the base class of {} is not known</source>
        <translation>die Basisklasse von {} ist nicht bekannt</translation>
    </message>
    <message>
        <source>the effect {} has no parameter '{}'</source>
        <translation>der Effekt {} hat keinen Parameter „{}“</translation>
    </message>
    <message>
        <source>declare it, or mend the name in the annotation</source>
        <translation>ihn deklarieren oder den Namen in der Annotation berichtigen</translation>
    </message>
    <message>
        <source>this effect has no such place in the model</source>
        <translation>diesen Ort hat der Effekt in dem Modell nicht</translation>
    </message>
    <message>
        <source>no simulation with this effect succeeded</source>
        <translation>keine Simulation mit diesem Effekt gelang</translation>
    </message>
    <message>
        <source>'{}' has no value here</source>
        <translation>„{}“ hat hier keinen Wert</translation>
    </message>
    <message>
        <source>it may use sample, duration and range(v), maxabs(v), rms(v), mean(v), start(v) of the effect's variables</source>
        <translation>erlaubt sind sample, duration und range(v), maxabs(v), rms(v), mean(v), start(v) der Variablen des Effekts</translation>
    </message>
    <message>
        <source>unknown class '{}'</source>
        <translation>unbekannte Klasse „{}“</translation>
    </message>
    <message>
        <source>The delayed signal {} acts on a state of the model.</source>
        <translation>Das verzögerte Signal {} wirkt auf einen Zustand des Modells.</translation>
    </message>
    <message>
        <source>Only inputs of the model can be delayed there; delays of other signals may lead to outputs alone.</source>
        <translation>Dort lassen sich nur Eingänge des Modells verzögern; Totzeiten anderer Signale dürfen nur zu Ausgängen führen.</translation>
    </message>
    <message>
        <source>A delay time depends on '{}', which varies in time.</source>
        <translation>Eine Totzeit hängt von „{}“ ab, das sich mit der Zeit ändert.</translation>
    </message>
    <message>
        <source>Use a parameter as the delay time.</source>
        <translation>Einen Parameter als Totzeit verwenden.</translation>
    </message>
    <message>
        <source>did you mean {}?</source>
        <translation>ist {} gemeint?</translation>
    </message>
    <message>
        <source>{} has no parameter {}</source>
        <translation>{} hat keinen Parameter {}</translation>
    </message>
    <message>
        <source>{} is no parameter and cannot be fitted or set</source>
        <translation>{} ist kein Parameter und kann weder angepasst noch gesetzt werden</translation>
    </message>
    <message>
        <source>{} is not a Real parameter and cannot be fitted or set</source>
        <translation>{} ist kein reeller Parameter und kann weder angepasst noch gesetzt werden</translation>
    </message>
    <message>
        <source>{} follows from an initial equation and cannot be fitted or set</source>
        <translation>{} folgt aus einer Anfangsgleichung und kann weder angepasst noch gesetzt werden</translation>
    </message>
    <message>
        <source>{} is final and cannot be fitted or set</source>
        <translation>{} ist „final“ und kann weder angepasst noch gesetzt werden</translation>
    </message>
    <message>
        <source>{} has shaped the equations (an array size or a condition) and cannot be fitted or set for one experiment</source>
        <translation>{} hat die Gleichungen geformt (eine Feldgröße oder eine Bedingung) und kann weder angepasst noch für einen Versuch allein gesetzt werden</translation>
    </message>
    <message>
        <source>input {} has no channel</source>
        <translation>Eingang {} hat keinen Kanal</translation>
    </message>
    <message>
        <source>map a column to it</source>
        <translation>ihm eine Spalte zuordnen</translation>
    </message>
    <message>
        <source>the model has no input {}</source>
        <translation>das Modell hat keinen Eingang {}</translation>
    </message>
    <message>
        <source>the model has no output {}</source>
        <translation>das Modell hat keinen Ausgang {}</translation>
    </message>
    <message>
        <source>the model has no inputs</source>
        <translation>das Modell hat keine Eingänge</translation>
    </message>
    <message>
        <source>the model has no outputs</source>
        <translation>das Modell hat keine Ausgänge</translation>
    </message>
    <message>
        <source>{} inputs over {} samples are named, but {} x {} values are given</source>
        <translation>genannt sind {} Eingänge über {} Abtastwerte, gegeben aber {} x {} Werte</translation>
    </message>
    <message>
        <source>{} outputs over {} samples are named, but {} x {} values are given</source>
        <translation>genannt sind {} Ausgänge über {} Abtastwerte, gegeben aber {} x {} Werte</translation>
    </message>
    <message>
        <source>{} is fitted for all experiments and has a start of its own here</source>
        <translation>{} wird für alle Versuche angepasst und hat hier einen eigenen Startwert</translation>
    </message>
    <message>
        <source>remove one of the two</source>
        <translation>eines von beiden entfernen</translation>
    </message>
    <message>
        <source>the start value of {} is not a number</source>
        <translation>der Startwert von {} ist keine Zahl</translation>
    </message>
    <message>
        <source>there is no model</source>
        <translation>es gibt kein Modell</translation>
    </message>
    <message>
        <source>the recording is empty</source>
        <translation>die Aufzeichnung ist leer</translation>
    </message>
    <message>
        <source>the time stamps do not increase</source>
        <translation>die Zeitstempel steigen nicht</translation>
    </message>
    <message>
        <source>the model has {} inputs over {} samples, but {} x {} values are given</source>
        <translation>das Modell hat {} Eingänge über {} Abtastwerte, gegeben sind aber {} x {} Werte</translation>
    </message>
    <message>
        <source>an input has values that are no numbers</source>
        <translation>ein Eingang hat Werte, die keine Zahlen sind</translation>
    </message>
    <message>
        <source>the model has {} outputs over {} samples, but {} x {} measured values are given</source>
        <translation>das Modell hat {} Ausgänge über {} Abtastwerte, gegeben sind aber {} x {} Messwerte</translation>
    </message>
    <message>
        <source>a measured value is infinite</source>
        <translation>ein Messwert ist unendlich</translation>
    </message>
    <message>
        <source>{} weights are given for {} outputs</source>
        <translation>gegeben sind {} Gewichte für {} Ausgänge</translation>
    </message>
    <message>
        <source>a weight is negative or not a number</source>
        <translation>ein Gewicht ist negativ oder keine Zahl</translation>
    </message>
    <message>
        <source>{} parameter values are given for {} parameters</source>
        <translation>gegeben sind {} Parameterwerte für {} Parameter</translation>
    </message>
    <message>
        <source>{}: the start value is not a number</source>
        <translation>{}: Der Startwert ist keine Zahl</translation>
    </message>
    <message>
        <source>{}: the lower bound {:.6g} is not below the upper bound {:.6g}</source>
        <translation>{}: Die untere Grenze {} liegt nicht unter der oberen Grenze {}</translation>
    </message>
    <message>
        <source>a parameter that is known need not be fitted</source>
        <translation>ein Parameter, der bekannt ist, muss nicht angepasst werden</translation>
    </message>
    <message>
        <source>{}: the start value {:.6g} is outside its bounds {:.6g} to {:.6g}</source>
        <translation>{}: Der Startwert {} liegt außerhalb der Grenzen {} bis {}</translation>
    </message>
    <message>
        <source>{}: a logarithmic scale needs a start value above 0, not {:.6g}</source>
        <translation>{}: Eine logarithmische Skala braucht einen Startwert über 0, nicht {}</translation>
    </message>
    <message>
        <source>{}: the prior {:.6g} ± {:.6g} is none</source>
        <translation>{}: {} ± {} ist kein Vorwissen</translation>
    </message>
    <message>
        <source>a prior has a mean and a standard deviation above 0</source>
        <translation>Vorwissen hat einen Mittelwert und eine Standardabweichung über 0</translation>
    </message>
    <message>
        <source>{}: there is no experiment number {}</source>
        <translation>{}: Einen Versuch Nummer {} gibt es nicht</translation>
    </message>
    <message>
        <source>{} is no free parameter of the model</source>
        <translation>{} ist kein freier Parameter des Modells</translation>
    </message>
    <message>
        <source>there is no experiment to fit</source>
        <translation>es gibt keinen Versuch zum Anpassen</translation>
    </message>
    <message>
        <source>give one the role fit</source>
        <translation>einem die Rolle „fit“ geben</translation>
    </message>
    <message>
        <source>{} is to be fitted twice</source>
        <translation>{} soll zweimal angepasst werden</translation>
    </message>
    <message>
        <source>nothing is measured: no output has values and a weight above 0</source>
        <translation>nichts ist gemessen: Kein Ausgang hat Werte und ein Gewicht über 0</translation>
    </message>
    <message>
        <source>{} measured values cannot determine {} parameters</source>
        <translation>{} Messwerte können {} Parameter nicht bestimmen</translation>
    </message>
    <message>
        <source>fix some parameters or add measurements</source>
        <translation>einige Parameter festhalten oder Messungen hinzufügen</translation>
    </message>
    <message>
        <source>'{}' has no free argument '{}'</source>
        <translation>„{}“ hat kein freies Argument „{}“</translation>
    </message>
    <message>
        <source>'{}' takes {} to {} arguments, not {}</source>
        <translation>„{}“ braucht {} bis {} Argumente, nicht {}</translation>
    </message>
    <message>
        <source>'{}' takes 1 argument, not {}</source>
        <translation>„{}“ braucht 1 Argument, nicht {}</translation>
    </message>
    <message>
        <source>'{}' takes {} arguments, not {}</source>
        <translation>„{}“ braucht {} Argumente, nicht {}</translation>
    </message>
    <message>
        <source>'{}' needs numbers, not {}</source>
        <translation>„{}“ braucht Zahlen, nicht {}</translation>
    </message>
    <message>
        <source>'{}' needs a single number here, not {}</source>
        <translation>„{}“ braucht hier eine einzelne Zahl, nicht {}</translation>
    </message>
    <message>
        <source>the table of '{}' must be a list of numbers known before the simulation</source>
        <translation>die Tabelle von „{}“ muss eine Liste von Zahlen sein, die vor der Simulation bekannt sind</translation>
    </message>
    <message>
        <source>an argument of '{}'</source>
        <translation>ein Argument von „{}“</translation>
    </message>
    <message>
        <source>{} is not a possible size</source>
        <translation>{} ist keine mögliche Größe</translation>
    </message>
    <message>
        <source>der needs a Real variable: an Integer does not vary continuously</source>
        <translation>der braucht eine Real-Variable: Eine Integer-Variable ändert sich nicht stetig</translation>
    </message>
    <message>
        <source>declare the variable as Real</source>
        <translation>die Variable als Real deklarieren</translation>
    </message>
    <message>
        <source>the delay time {} is longer than the longest one, {}</source>
        <translation>die Totzeit {} ist länger als die längste, {}</translation>
    </message>
    <message>
        <source>delay(signal, time, longest time)</source>
        <translation>delay(Signal, Zeit, längste Zeit)</translation>
    </message>
    <message>
        <source>&apos;{}&apos; changes at events alone and has no derivative</source>
        <translation>„{}“ ändert sich nur bei Ereignissen und hat keine Ableitung</translation>
    </message>
    <message>
        <source>remove the prefix &apos;discrete&apos;</source>
        <translation>das Präfix „discrete“ entfernen</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is imported from &apos;{}&apos; and from &apos;{}&apos;</source>
        <translation>„{}“ wird aus „{}“ und aus „{}“ importiert</translation>
    </message>
    <message>
        <source>import the one that is meant by its name</source>
        <translation>das gemeinte unter seinem Namen importieren</translation>
    </message>
    <message>
        <source>the delay time must be a parameter</source>
        <translation>die Totzeit muss ein Parameter sein</translation>
    </message>
    <message>
        <source>a delay that changes while the model runs is not supported</source>
        <translation>eine Totzeit, die sich ändert, während das Modell läuft, wird nicht unterstützt</translation>
    </message>
    <message>
        <source>'{}' takes one array</source>
        <translation>„{}“ braucht ein Feld</translation>
    </message>
    <message>
        <source>'{}' needs an array of numbers, not {}</source>
        <translation>„{}“ braucht ein Feld von Zahlen, nicht {}</translation>
    </message>
    <message>
        <source>'{}' of an empty array</source>
        <translation>„{}“ eines leeren Feldes</translation>
    </message>
    <message>
        <source>{} has no dimension {}</source>
        <translation>{} hat keine Dimension {}</translation>
    </message>
    <message>
        <source>'{}' needs the sizes of the array</source>
        <translation>„{}“ braucht die Größen des Feldes</translation>
    </message>
    <message>
        <source>'fill' needs a single value</source>
        <translation>„fill“ braucht einen einzelnen Wert</translation>
    </message>
    <message>
        <source>an array of more than {} elements</source>
        <translation>ein Feld mit mehr als {} Elementen</translation>
    </message>
    <message>
        <source>'linspace' needs 2 points or more</source>
        <translation>„linspace“ braucht 2 Punkte oder mehr</translation>
    </message>
    <message>
        <source>'scalar' needs one element, not {}</source>
        <translation>„scalar“ braucht ein Element, nicht {}</translation>
    </message>
    <message>
        <source>'Integer' needs an enumeration, not {}</source>
        <translation>„Integer“ braucht eine Aufzählung, nicht {}</translation>
    </message>
    <message>
        <source>the table has {} abscissas and {} ordinates</source>
        <translation>die Tabelle hat {} Abszissen und {} Ordinaten</translation>
    </message>
    <message>
        <source>the abscissas of the table must rise: {} follows {}</source>
        <translation>die Abszissen der Tabelle müssen steigen: {} folgt auf {}</translation>
    </message>
    <message>
        <source>the function '{}' is not supported</source>
        <translation>die Funktion „{}“ wird nicht unterstützt</translation>
    </message>
    <message>
        <source>'{}' is a {}; calling it is not supported</source>
        <translation>„{}“ ist ein {}; der Aufruf wird nicht unterstützt</translation>
    </message>
    <message>
        <source>write its equations where they are needed</source>
        <translation>seine Gleichungen dort schreiben, wo sie gebraucht werden</translation>
    </message>
    <message>
        <source>the function '{}' is not known</source>
        <translation>die Funktion „{}“ ist nicht bekannt</translation>
    </message>
    <message>
        <source>'{}' cannot be applied to {} and {}</source>
        <translation>„{}“ lässt sich nicht auf {} und {} anwenden</translation>
    </message>
    <message>
        <source>both sides must be numbers</source>
        <translation>beide Seiten müssen Zahlen sein</translation>
    </message>
    <message>
        <source>the sizes must agree</source>
        <translation>die Größen müssen übereinstimmen</translation>
    </message>
    <message>
        <source>to apply it to each element write '.{}'</source>
        <translation>für jedes Element einzeln „.{}“ schreiben</translation>
    </message>
    <message>
        <source>the inner sizes of a product must agree; '.*' multiplies element by element</source>
        <translation>die inneren Größen eines Produkts müssen übereinstimmen; „.*“ multipliziert Element für Element</translation>
    </message>
    <message>
        <source>to divide element by element write './'</source>
        <translation>zum Teilen Element für Element „./“ schreiben</translation>
    </message>
    <message>
        <source>to apply it to each element write '.^'</source>
        <translation>für jedes Element einzeln „.^“ schreiben</translation>
    </message>
    <message>
        <source>'{}' cannot compare {} with {}</source>
        <translation>„{}“ kann {} nicht mit {} vergleichen</translation>
    </message>
    <message>
        <source>the operator '{}' is not supported</source>
        <translation>der Operator „{}“ wird nicht unterstützt</translation>
    </message>
    <message>
        <source>'{}' needs Boolean values, not {} and {}</source>
        <translation>„{}“ braucht Boolean-Werte, nicht {} und {}</translation>
    </message>
    <message>
        <source>{} has no variable that begins at {}</source>
        <translation>{} hat keine Größe, die bei {} beginnt</translation>
    </message>
    <message>
        <source>{} has no parameter {} that could change</source>
        <translation>{} hat keinen Parameter {}, der sich ändern könnte</translation>
    </message>
    <message>
        <source>{} has a variable {} already</source>
        <translation>{} hat schon eine Variable {}</translation>
    </message>
    <message>
        <source>no equation of {} sets {} alone</source>
        <translation>keine Gleichung von {} bestimmt {} allein</translation>
    </message>
    <message>
        <source>no such file or directory</source>
        <translation>Datei oder Verzeichnis gibt es nicht</translation>
    </message>
    <message>
        <source>the class &quot;{}&quot; is defined twice</source>
        <translation>die Klasse „{}“ ist zweimal definiert</translation>
    </message>
    <message>
        <source>the directory holds no package.mo</source>
        <translation>das Verzeichnis enthält keine package.mo</translation>
    </message>
    <message>
        <source>give the directory of a package, or one .mo file</source>
        <translation>das Verzeichnis eines Pakets oder eine einzelne .mo-Datei angeben</translation>
    </message>
    <message>
        <source>packages are nested too deep</source>
        <translation>Pakete sind zu tief verschachtelt</translation>
    </message>
    <message>
        <source>&quot;{}&quot; stands in package.mo and in a file of its own</source>
        <translation>„{}“ steht in package.mo und in einer eigenen Datei</translation>
    </message>
    <message>
        <source>keep one of the two</source>
        <translation>eines von beiden behalten</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is listed but not there</source>
        <translation>„{}“ ist aufgeführt, aber nicht vorhanden</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is listed twice</source>
        <translation>„{}“ ist zweimal aufgeführt</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is not listed</source>
        <translation>„{}“ ist nicht aufgeführt</translation>
    </message>
    <message>
        <source>add a line with its name</source>
        <translation>eine Zeile mit seinem Namen hinzufügen</translation>
    </message>
    <message>
        <source>a file of a package holds one class</source>
        <translation>eine Datei eines Pakets enthält eine Klasse</translation>
    </message>
    <message>
        <source>give the second class a file of its own</source>
        <translation>der zweiten Klasse eine eigene Datei geben</translation>
    </message>
    <message>
        <source>the class is called &quot;{}&quot;, its place on the disk &quot;{}&quot;</source>
        <translation>die Klasse heißt „{}“, ihr Platz auf dem Datenträger „{}“</translation>
    </message>
    <message>
        <source>rename one of the two</source>
        <translation>eines von beiden umbenennen</translation>
    </message>
    <message>
        <source>a top package stands within no other, not within &quot;{}&quot;</source>
        <translation>ein oberstes Paket steht in keinem anderen, auch nicht in „{}“</translation>
    </message>
    <message>
        <source>the file belongs to &quot;{}&quot; and must say so</source>
        <translation>die Datei gehört zu „{}“ und muss das angeben</translation>
    </message>
    <message>
        <source>write &quot;within ;&quot;</source>
        <translation>„within ;“ schreiben</translation>
    </message>
    <message>
        <source>write &quot;within {};&quot;</source>
        <translation>„within {};“ schreiben</translation>
    </message>
    <message>
        <source>Two sources or fixed values act on the same quantity; remove one of them.</source>
        <translation>Zwei Quellen oder feste Werte wirken auf dieselbe Größe; eine davon entfernen.</translation>
    </message>
    <message>
        <source>The equation {} cannot hold: other equations fix the same quantities to different values.</source>
        <translation>Die Gleichung {} kann nicht gelten: Andere Gleichungen legen dieselben Größen auf andere Werte fest.</translation>
    </message>
    <message>
        <source>The equation {} fixes an input of the model, which is given from outside.</source>
        <translation>Die Gleichung {} legt einen Eingang des Modells fest, der von außen vorgegeben ist.</translation>
    </message>
    <message>
        <source>, as the derivative of {}</source>
        <translation>, als Ableitung von {}</translation>
    </message>
    <message>
        <source>The derivative of the input '{}' is fixed by the equations.</source>
        <translation>Die Ableitung des Eingangs „{}“ ist durch die Gleichungen festgelegt.</translation>
    </message>
    <message>
        <source>The model needs the second derivative of the input '{}'{}.</source>
        <translation>Das Modell braucht die zweite Ableitung des Eingangs „{}“{}.</translation>
    </message>
    <message>
        <source>'{}' and '{}' are the same quantity, but their start values are fixed to {} and {}.</source>
        <translation>„{}“ und „{}“ sind dieselbe Größe, aber ihre Startwerte sind auf {} und {} festgelegt.</translation>
    </message>
    <message>
        <source>Give both the same start value, or free one of them (fixed = false).</source>
        <translation>Beiden denselben Startwert geben oder einen freigeben (fixed = false).</translation>
    </message>
    <message>
        <source>'{}' and '{}' are the same quantity; the fixed start value of '{}' is used.</source>
        <translation>„{}“ und „{}“ sind dieselbe Größe; verwendet wird der feste Startwert von „{}“.</translation>
    </message>
    <message>
        <source>The fixed start value of '{}' is not used: the input '{}' prescribes it.</source>
        <translation>Der feste Startwert von „{}“ wird nicht verwendet: Der Eingang „{}“ gibt ihn vor.</translation>
    </message>
    <message>
        <source>{} (in {})</source>
        <translation>{} (in {})</translation>
    </message>
    <message>
        <source>A recorded signal runs linearly between its samples: it has a slope and no second derivative. Leave out the inertia that follows it rigidly, drive it through a spring and damper, or pass the signal through Signals.FirstOrder twice.</source>
        <translation>Ein aufgezeichnetes Signal verläuft zwischen seinen Abtastwerten linear: Es hat eine Steigung und keine zweite Ableitung. Die Trägheit, die ihm starr folgt, weglassen, sie über Feder und Dämpfer antreiben oder das Signal zweimal durch Signals.FirstOrder führen.</translation>
    </message>
    <message>
        <source>'{}' is infinite</source>
        <translation>„{}“ ist unendlich</translation>
    </message>
    <message>
        <source>'{}' is not a number</source>
        <translation>„{}“ ist keine Zahl</translation>
    </message>
    <message>
        <source>it holds a constant that is infinite</source>
        <translation>sie enthält eine Konstante, die unendlich ist</translation>
    </message>
    <message>
        <source>it holds a constant that is not a number</source>
        <translation>sie enthält eine Konstante, die keine Zahl ist</translation>
    </message>
    <message>
        <source>{} = {}</source>
        <translation>{} = {}</translation>
    </message>
    <message>
        <source>the value of '{}'</source>
        <translation>der Wert von „{}“</translation>
    </message>
    <message>
        <source>{} divides by 0{}</source>
        <translation>{} teilt durch 0{}</translation>
    </message>
    <message>
        <source>{} is infinite{}</source>
        <translation>{} ist unendlich{}</translation>
    </message>
    <message>
        <source>{} is not a number{}</source>
        <translation>{} ist keine Zahl{}</translation>
    </message>
    <message>
        <source>The equation {} = {} cannot hold: {}.</source>
        <translation>Die Gleichung {} = {} kann nicht gelten: {}.</translation>
    </message>
    <message>
        <source>Give the parameter another value, or write the equation without it.</source>
        <translation>Dem Parameter einen anderen Wert geben oder die Gleichung ohne ihn schreiben.</translation>
    </message>
    <message>
        <source>The model needs the second derivative of the input '{}'.</source>
        <translation>Das Modell braucht die zweite Ableitung des Eingangs „{}“.</translation>
    </message>
    <message>
        <source>The equation {} would have to be differentiated too often; the equations constrain each other in a circle.</source>
        <translation>Die Gleichung {} müsste zu oft abgeleitet werden; die Gleichungen binden einander im Kreis.</translation>
    </message>
    <message>
        <source>The equation {} would have to be differentiated although it holds a delayed signal.</source>
        <translation>Die Gleichung {} müsste abgeleitet werden, obwohl sie ein verzögertes Signal enthält.</translation>
    </message>
    <message>
        <source>No state can be eliminated by the constraint {}.</source>
        <translation>Durch die Bindung {} lässt sich kein Zustand eliminieren.</translation>
    </message>
    <message>
        <source>and {} more</source>
        <translation>und {} weitere</translation>
    </message>
    <message>
        <source>{} would have to be a state; give it a name of its own in the model.</source>
        <translation>{} müsste ein Zustand sein; ihm im Modell einen eigenen Namen geben.</translation>
    </message>
    <message>
        <source>The equations {} do not determine {}: what they say of it cancels.</source>
        <translation>Die Gleichungen {} bestimmen {} nicht: Was sie darüber sagen, hebt sich auf.</translation>
    </message>
    <message>
        <source>{} is not fitted: it has no profile</source>
        <translation>{} wird nicht angepasst: Es gibt kein Profil davon</translation>
    </message>
    <message>
        <source>fitted: {}</source>
        <translation>angepasst werden: {}</translation>
    </message>
    <message>
        <source>the FMU holds C sources and no binary: {}</source>
        <translation>die FMU enthält C-Quelltexte und kein Binärprogramm: {}</translation>
    </message>
    <message>
        <source>The importing tool must compile it; documentation/index.html says how.</source>
        <translation>Das importierende Werkzeug muss sie übersetzen; documentation/index.html sagt, wie.</translation>
    </message>
    <message>
        <source>no C compiler (cc) is on PATH</source>
        <translation>kein C-Compiler (cc) liegt im PATH</translation>
    </message>
    <message>
        <source>the C compiler (cc) failed</source>
        <translation>der C-Compiler (cc) scheiterte</translation>
    </message>
    <message>
        <source>the C compiler (cc) was still busy after {} s and was ended</source>
        <translation>der C-Compiler (cc) war nach {} s noch beschäftigt und wurde beendet</translation>
    </message>
    <message>
        <source>the C compiler (cc) failed: {}</source>
        <translation>der C-Compiler (cc) scheiterte: {}</translation>
    </message>
    <message>
        <source>on this platform none is made</source>
        <translation>auf dieser Plattform wird keines erzeugt</translation>
    </message>
    <message>
        <source>the study's class {} is in none of its files</source>
        <translation>die Klasse {} der Studie steht in keiner ihrer Dateien</translation>
    </message>
    <message>
        <source>a formula of signals cannot hold this</source>
        <translation>das kann in einer Formel von Signalen nicht stehen</translation>
    </message>
    <message>
        <source>use names of signals, numbers, + - * / ^, abs, sqrt, exp, log, log10, sin, cos, tan, min, max, der and integral</source>
        <translation>Namen von Signalen, Zahlen, + - * / ^, abs, sqrt, exp, log, log10, sin, cos, tan, min, max, der und integral verwenden</translation>
    </message>
    <message>
        <source>there is no signal {}</source>
        <translation>es gibt kein Signal {}</translation>
    </message>
    <message>
        <source>the unit {} of {} is not known</source>
        <translation>die Einheit {} von {} ist nicht bekannt</translation>
    </message>
    <message>
        <source>the units {} and {} do not agree</source>
        <translation>die Einheiten {} und {} passen nicht zusammen</translation>
    </message>
    <message>
        <source>the power of a quantity with a unit must be a number</source>
        <translation>der Exponent einer Größe mit Einheit muss eine Zahl sein</translation>
    </message>
    <message>
        <source>a pure number is needed, this is in {}</source>
        <translation>hier muss eine reine Zahl stehen, dies ist in {}</translation>
    </message>
    <message>
        <source>a spectrum needs at least {} samples, half of which may be missing; here are {} of {}</source>
        <translation>ein Spektrum braucht mindestens {} Abtastwerte, von denen die Hälfte fehlen darf; hier sind es {} von {}</translation>
    </message>
    <message>
        <source>a coherence needs at least two segments of {} samples; there are {}</source>
        <translation>eine Kohärenz braucht mindestens zwei Abschnitte von {} Abtastwerten; es gibt {}</translation>
    </message>
    <message>
        <source>there is no number to count</source>
        <translation>es gibt keine Zahl, die gezählt werden könnte</translation>
    </message>
    <message>
        <source>the model has no variable {}</source>
        <translation>das Modell hat keine Variable {}</translation>
    </message>
    <message>
        <source>take it out of the plot, or choose another one</source>
        <translation>sie aus dem Diagramm nehmen oder eine andere wählen</translation>
    </message>
    <message>
        <source>the study has no experiment {}</source>
        <translation>die Studie hat kein Experiment {}</translation>
    </message>
    <message>
        <source>the simulation of experiment "{}" stopped at t = {:.6g} s: {}</source>
        <translation>die Simulation des Experiments „{}“ blieb bei t = {:.6g} s stehen: {}</translation>
    </message>
    <message>
        <source>the file of {} was not read</source>
        <translation>die Datei von {} wurde nicht gelesen</translation>
    </message>
    <message>
        <source>{} was not read from its file</source>
        <translation>{} wurde nicht aus der Datei gelesen</translation>
    </message>
    <message>
        <source>Map it to an input or an output of the model.</source>
        <translation>Einem Eingang oder Ausgang des Modells zuordnen.</translation>
    </message>
    <message>
        <source>the formula uses no signal</source>
        <translation>die Formel benutzt kein Signal</translation>
    </message>
    <message>
        <source>the model has no parameter {} that may change</source>
        <translation>das Modell hat keinen Parameter {}, der sich ändern darf</translation>
    </message>
    <message>
        <source>a campaign is an object {{…}}</source>
        <translation>eine Kampagne ist ein Objekt {{…}}</translation>
    </message>
    <message>
        <source>a campaign has the command &quot;fit&quot; or &quot;discover&quot;, and not &quot;{}&quot;</source>
        <translation>eine Kampagne hat den Befehl &quot;fit&quot; oder &quot;discover&quot; und nicht &quot;{}&quot;</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is no member of a campaign</source>
        <translation>&quot;{}&quot; ist kein Eintrag einer Kampagne</translation>
    </message>
    <message>
        <source>Known here: {}.</source>
        <translation>Bekannt sind hier: {}.</translation>
    </message>
    <message>
        <source>{}: expected a text that is not empty</source>
        <translation>{}: erwartet wird ein Text, der nicht leer ist</translation>
    </message>
    <message>
        <source>the member &quot;{}&quot; is missing</source>
        <translation>der Eintrag &quot;{}&quot; fehlt</translation>
    </message>
    <message>
        <source>{}: expected an object {{name: column}}</source>
        <translation>{}: erwartet wird ein Objekt {{Name: Spalte}}</translation>
    </message>
    <message>
        <source>no recording is of a unit</source>
        <translation>keine Aufzeichnung gehört einem Exemplar</translation>
    </message>
    <message>
        <source>&quot;files&quot; names the column with the path of a recording, for each experiment.</source>
        <translation>&quot;files&quot; nennt für jedes Experiment die Spalte mit dem Pfad seiner Aufzeichnung.</translation>
    </message>
    <message>
        <source>expected a list […] of columns</source>
        <translation>erwartet wird eine Liste […] von Spalten</translation>
    </message>
    <message>
        <source>the unit has no name</source>
        <translation>das Exemplar hat keinen Namen</translation>
    </message>
    <message>
        <source>the name of the unit is longer than {} bytes</source>
        <translation>der Name des Exemplars ist länger als {} Byte</translation>
    </message>
    <message>
        <source>the name of the unit begins with a point</source>
        <translation>der Name des Exemplars beginnt mit einem Punkt</translation>
    </message>
    <message>
        <source>the name of the unit holds a character that no folder&apos;s name may have</source>
        <translation>der Name des Exemplars enthält ein Zeichen, das kein Ordnername haben darf</translation>
    </message>
    <message>
        <source>the unit &quot;{}&quot; stands in line {} already</source>
        <translation>das Exemplar &quot;{}&quot; steht schon in Zeile {}</translation>
    </message>
    <message>
        <source>Give each unit a name of its own.</source>
        <translation>Jedem Exemplar einen eigenen Namen geben.</translation>
    </message>
    <message>
        <source>the table has no unit</source>
        <translation>die Tabelle enthält kein Exemplar</translation>
    </message>
    <message>
        <source>the table of units has {} columns &quot;{}&quot;</source>
        <translation>die Tabelle der Exemplare hat {} Spalten &quot;{}&quot;</translation>
    </message>
    <message>
        <source>Write the whole header, with its unit.</source>
        <translation>Die ganze Überschrift mit ihrer Einheit schreiben.</translation>
    </message>
    <message>
        <source>the table of units has no column &quot;{}&quot;</source>
        <translation>die Tabelle der Exemplare hat keine Spalte &quot;{}&quot;</translation>
    </message>
    <message>
        <source>It has {}.</source>
        <translation>Sie hat {}.</translation>
    </message>
    <message>
        <source>the campaign names the unit {} and the table {}</source>
        <translation>die Kampagne nennt die Einheit {} und die Tabelle {}</translation>
    </message>
    <message>
        <source>Name the column as the table does.</source>
        <translation>Die Spalte so nennen, wie die Tabelle es tut.</translation>
    </message>
    <message>
        <source>the unit &quot;{}&quot; is not known</source>
        <translation>die Einheit &quot;{}&quot; ist nicht bekannt</translation>
    </message>
    <message>
        <source>Its results lie in a folder of that name.</source>
        <translation>Seine Ergebnisse liegen in einem Ordner dieses Namens.</translation>
    </message>
    <message>
        <source>the unit has no recording for &quot;{}&quot;</source>
        <translation>das Exemplar hat keine Aufzeichnung für &quot;{}&quot;</translation>
    </message>
    <message>
        <source>{}: expected a number, found &quot;{}&quot;</source>
        <translation>{}: erwartet wird eine Zahl, gefunden &quot;{}&quot;</translation>
    </message>
    <message>
        <source>Leave the cell empty where it is not known.</source>
        <translation>Die Zelle leer lassen, wo der Wert nicht bekannt ist.</translation>
    </message>
    <message>
        <source>there is no study &quot;{}&quot;</source>
        <translation>es gibt keine Studie &quot;{}&quot;</translation>
    </message>
    <message>
        <source>The path is relative to the campaign&apos;s folder.</source>
        <translation>Der Pfad gilt ab dem Ordner der Kampagne.</translation>
    </message>
    <message>
        <source>there is no table &quot;{}&quot;</source>
        <translation>es gibt keine Tabelle &quot;{}&quot;</translation>
    </message>
    <message>
        <source>the table of units was changed while the campaign ran</source>
        <translation>die Tabelle der Exemplare wurde während der Kampagne geändert</translation>
    </message>
    <message>
        <source>Start the campaign again: it goes on with the units as they are now.</source>
        <translation>Die Kampagne erneut starten: sie fährt mit den Exemplaren fort, wie sie jetzt sind.</translation>
    </message>
    <message>
        <source>there is no Slurm here: &quot;{}&quot; is not among the programs of this machine</source>
        <translation>hier gibt es kein Slurm: &quot;{}&quot; gehört nicht zu den Programmen dieses Rechners</translation>
    </message>
    <message>
        <source>Start the campaign where jobs are submitted (a login node of the cluster), or work on it here, with --jobs N.</source>
        <translation>Die Kampagne dort starten, wo Jobs eingereicht werden (ein Anmelderechner des Clusters), oder hier bearbeiten, mit --jobs N.</translation>
    </message>
    <message>
        <source>Slurm does not answer: {}</source>
        <translation>Slurm antwortet nicht: {}</translation>
    </message>
    <message>
        <source>&quot;scontrol ping&quot; tells whether the controller runs.</source>
        <translation>&quot;scontrol ping&quot; sagt, ob die Steuerung läuft.</translation>
    </message>
    <message>
        <source>this Slurm takes no job arrays (MaxArraySize is {})</source>
        <translation>dieses Slurm nimmt keine Array-Jobs (MaxArraySize ist {})</translation>
    </message>
    <message>
        <source>Ask who runs the cluster, or work on the campaign here, with --jobs N.</source>
        <translation>Den Betreiber des Clusters fragen, oder die Kampagne hier bearbeiten, mit --jobs N.</translation>
    </message>
    <message>
        <source>Slurm does not take the job: {}</source>
        <translation>Slurm nimmt den Job nicht an: {}</translation>
    </message>
    <message>
        <source>What follows --slurm goes to sbatch, for example --slurm &quot;--partition=short --time=60&quot;.</source>
        <translation>Was auf --slurm folgt, geht an sbatch, zum Beispiel --slurm &quot;--partition=short --time=60&quot;.</translation>
    </message>
    <message>
        <source>no unit is planned for this task of the array</source>
        <translation>für diese Aufgabe des Arrays ist kein Exemplar vorgesehen</translation>
    </message>
    <message>
        <source>&quot;analogon-cli campaign&quot; with --slurm submits it.</source>
        <translation>&quot;analogon-cli campaign&quot; mit --slurm reicht sie ein.</translation>
    </message>
    <message>
        <source>Slurm job {} of an earlier run is followed</source>
        <translation>der Slurm-Job {} eines früheren Laufs wird verfolgt</translation>
    </message>
    <message>
        <source>this is no campaign: its format is &quot;{}&quot;</source>
        <translation>dies ist keine Kampagne: Ihr Format ist „{}“</translation>
    </message>
    <message>
        <source>A campaign has the format &quot;{}&quot;, and names a study and a table of units.</source>
        <translation>Eine Kampagne hat das Format „{}“ und nennt eine Studie und eine Tabelle der Exemplare.</translation>
    </message>
    <message>
        <source>A campaign is a file, campaign.json, that names a study and a table of units.</source>
        <translation>Eine Kampagne ist eine Datei, campaign.json, die eine Studie und eine Tabelle der Exemplare nennt.</translation>
    </message>
    <message>
        <source>this is a directory; name a file</source>
        <translation>dies ist ein Verzeichnis; eine Datei angeben</translation>
    </message>
    <message>
        <source>failed: {}: {}</source>
        <translation>fehlgeschlagen: {}: {}</translation>
    </message>
    <message>
        <source>and {} more units; results.csv names them</source>
        <translation>und {} weitere Exemplare; results.csv nennt sie</translation>
    </message>
    <message>
        <source>interrupted; the same command goes on where it was</source>
        <translation>unterbrochen; derselbe Befehl setzt fort, wo es war</translation>
    </message>
    <message>
        <source>1 unit is done already</source>
        <translation>1 Exemplar ist schon fertig</translation>
    </message>
    <message>
        <source>{} units are done already</source>
        <translation>{} Exemplare sind schon fertig</translation>
    </message>
    <message>
        <source>1 unit has changed since it was worked on (study, row or recordings) and is worked on again</source>
        <translation>1 Exemplar hat sich seit seiner Bearbeitung geändert (Studie, Zeile oder Aufzeichnungen) und wird neu bearbeitet</translation>
    </message>
    <message>
        <source>{} units have changed since they were worked on (study, row or recordings) and are worked on again</source>
        <translation>{} Exemplare haben sich seit ihrer Bearbeitung geändert (Studie, Zeile oder Aufzeichnungen) und werden neu bearbeitet</translation>
    </message>
    <message>
        <source>Slurm job {} works on; &quot;scancel {}&quot; ends it</source>
        <translation>der Slurm-Job {} arbeitet weiter; &quot;scancel {}&quot; beendet ihn</translation>
    </message>
    <message>
        <source>Slurm job {} was cancelled</source>
        <translation>der Slurm-Job {} wurde abgebrochen</translation>
    </message>
    <message>
        <source>Slurm job {}: {} units in {} tasks</source>
        <translation>Slurm-Job {}: {} Exemplare in {} Aufgaben</translation>
    </message>
    <message>
        <source>the tasks of Slurm job {} could not begin: {}</source>
        <translation>die Aufgaben des Slurm-Jobs {} konnten nicht beginnen: {}</translation>
    </message>
    <message>
        <source>{} tasks of Slurm job {} ended before their units were done; these are submitted again</source>
        <translation>{} Aufgaben des Slurm-Jobs {} endeten, bevor ihre Exemplare fertig waren; diese werden noch einmal eingereicht</translation>
    </message>
    <message>
        <source>the tasks of Slurm job {} could not begin</source>
        <translation>die Aufgaben des Slurm-Jobs {} konnten nicht beginnen</translation>
    </message>
    <message>
        <source>This program, the campaign, its recordings and &quot;{}&quot; must lie where every node sees them.</source>
        <translation>Dieses Programm, die Kampagne, ihre Aufzeichnungen und &quot;{}&quot; müssen dort liegen, wo jeder Knoten sie sieht.</translation>
    </message>
    <message>
        <source>Slurm job {} waits: {}</source>
        <translation>der Slurm-Job {} wartet: {}</translation>
    </message>
    <message>
        <source>Slurm job {} works on this campaign</source>
        <translation>der Slurm-Job {} arbeitet an dieser Kampagne</translation>
    </message>
    <message>
        <source>Follow it with --slurm, or end it with &quot;scancel {}&quot;.</source>
        <translation>Mit --slurm verfolgen, oder mit &quot;scancel {}&quot; beenden.</translation>
    </message>
    <message>
        <source>Give a new or an empty directory, or that of an earlier campaign.</source>
        <translation>Ein neues oder leeres Verzeichnis angeben oder das einer früheren Kampagne.</translation>
    </message>
    <message>
        <source>a campaign needs a directory, and this is none</source>
        <translation>eine Kampagne braucht ein Verzeichnis, und dies ist keines</translation>
    </message>
    <message>
        <source>another run works on this campaign</source>
        <translation>ein anderer Lauf arbeitet an dieser Kampagne</translation>
    </message>
    <message>
        <source>this directory holds something else than a campaign&apos;s results</source>
        <translation>dieses Verzeichnis enthält anderes als Ergebnisse einer Kampagne</translation>
    </message>
    <message>
        <source>the study has no experiment &quot;{}&quot;</source>
        <translation>die Studie hat kein Experiment &quot;{}&quot;</translation>
    </message>
    <message>
        <source>the model has no parameter &quot;{}&quot;</source>
        <translation>das Modell hat keinen Parameter &quot;{}&quot;</translation>
    </message>
    <message>
        <source>The table gives &quot;{}&quot; in this unit.</source>
        <translation>Die Tabelle gibt &quot;{}&quot; in dieser Einheit an.</translation>
    </message>
    <message>
        <source>there is no recording &quot;{}&quot;</source>
        <translation>es gibt keine Aufzeichnung &quot;{}&quot;</translation>
    </message>
    <message>
        <source>The path is relative to the folder of the table.</source>
        <translation>Der Pfad gilt ab dem Ordner der Tabelle.</translation>
    </message>
    <message>
        <source>the table of units is no text in UTF-8</source>
        <translation>die Tabelle der Exemplare ist kein Text in UTF-8</translation>
    </message>
    <message>
        <source>Save it as UTF-8.</source>
        <translation>Als UTF-8 speichern.</translation>
    </message>
    <message>
        <source>a quote is not closed in this line</source>
        <translation>in dieser Zeile ist ein Anführungszeichen nicht geschlossen</translation>
    </message>
    <message>
        <source>Close it; a cell of this table ends with its line.</source>
        <translation>Es schließen; eine Zelle dieser Tabelle endet mit ihrer Zeile.</translation>
    </message>
    <message>
        <source>the row has {} cells and the header {}</source>
        <translation>die Zeile hat {} Zellen und die Überschrift {}</translation>
    </message>
    <message>
        <source>no process can be started: {}</source>
        <translation>es lässt sich kein Prozess starten: {}</translation>
    </message>
    <message>
        <source>a process for the units could not begin: {}</source>
        <translation>ein Prozess für die Exemplare konnte nicht beginnen: {}</translation>
    </message>
    <message>
        <source>no experiment of the study is used</source>
        <translation>kein Versuch der Studie wird verwendet</translation>
    </message>
    <message>
        <source>Take one back in: leave out its "use": false.</source>
        <translation>Einen wieder einbeziehen: dessen "use": false weglassen.</translation>
    </message>
    <message>
        <source>only {} of {} recordings were looked at: {}</source>
        <translation>nur {} von {} Aufzeichnungen wurden betrachtet: {}</translation>
    </message>
    <message>
        <source>only {} of {} recordings were looked at</source>
        <translation>nur {} von {} Aufzeichnungen wurden betrachtet</translation>
    </message>
    <message>
        <source>nothing drives the input '{}' of the model</source>
        <translation>nichts treibt den Eingang '{}' des Modells an</translation>
    </message>
    <message>
        <source>Connect a source of the library to it (a step, a sine, a table), or import a recording and map a column to it.</source>
        <translation>Eine Quelle der Bibliothek mit ihm verbinden (Sprung, Sinus, Tabelle), oder eine Aufzeichnung importieren und ihm eine Spalte zuordnen.</translation>
    </message>
    <message>
        <source>'{}' has no place for a stop time</source>
        <translation>'{}' hat keinen Platz für eine Endzeit</translation>
    </message>
    <message>
        <source>Write it as 'model {} extends …; end {};'.</source>
        <translation>Es als 'model {} extends …; end {};' schreiben.</translation>
    </message>
    <message>
        <source>the run has no values to record</source>
        <translation>der Lauf hat keine Werte, die aufzuzeichnen wären</translation>
    </message>
    <message>
        <source>a sample time of {} s does not fit into a run of {} s</source>
        <translation>eine Abtastzeit von {} s passt nicht in einen Lauf von {} s</translation>
    </message>
    <message>
        <source>Choose one above 0 that is shorter than the run.</source>
        <translation>Eine über 0 wählen, die kürzer ist als der Lauf.</translation>
    </message>
    <message>
        <source>a sample time of {} s gives more than ten million samples</source>
        <translation>eine Abtastzeit von {} s gibt mehr als zehn Millionen Abtastwerte</translation>
    </message>
    <message>
        <source>Choose a longer one.</source>
        <translation>Eine längere wählen.</translation>
    </message>
    <message>
        <source>the noise of '{}' cannot have the standard deviation {}</source>
        <translation>das Rauschen von '{}' kann nicht die Standardabweichung {} haben</translation>
    </message>
    <message>
        <source>Give 0 or more, in the unit of the output.</source>
        <translation>0 oder mehr angeben, in der Einheit des Ausgangs.</translation>
    </message>
    <message>
        <source>the simulation would end at {}, before it begins at {}</source>
        <translation>die Simulation würde bei {} enden, vor ihrem Beginn bei {}</translation>
    </message>
    <message>
        <source>no parameter is fitted</source>
        <translation>kein Parameter wird angepasst</translation>
    </message>
    <message>
        <source>check the parameters that are to be looked at</source>
        <translation>die Parameter anhaken, die betrachtet werden sollen</translation>
    </message>
    <message>
        <source>a sweep leads one or two parameters through values, not {}</source>
        <translation>ein oder zwei Parameter lassen sich durchfahren, nicht {}</translation>
    </message>
    <message>
        <source>the sweep has no values for {}</source>
        <translation>für {} sind keine Werte zum Durchfahren da</translation>
    </message>
    <message>
        <source>both axes of the sweep are {}</source>
        <translation>beide Achsen sind {}</translation>
    </message>
    <message>
        <source>the logo has {} kB, and a report carries up to {}</source>
        <translation>das Logo hat {} kB, und ein Bericht trägt bis zu {}</translation>
    </message>
    <message>
        <source>Save it smaller: a logo is shown 64 pixels high.</source>
        <translation>Kleiner speichern: ein Logo wird 64 Pixel hoch gezeigt.</translation>
    </message>
    <message>
        <source>the logo is neither PNG, JPEG nor SVG</source>
        <translation>das Logo ist weder PNG noch JPEG noch SVG</translation>
    </message>
    <message>
        <source>Save it in one of these formats.</source>
        <translation>In einem dieser Formate speichern.</translation>
    </message>
    <message>
        <source>the head of the report must be a group of named texts</source>
        <translation>der Kopf des Berichts muss eine Gruppe benannter Texte sein</translation>
    </message>
    <message>
        <source>the head of the report: "{}" must be a text</source>
        <translation>der Kopf des Berichts: „{}“ muss ein Text sein</translation>
    </message>
    <message>
        <source>the head of the report: "{}" must be a list of sections</source>
        <translation>der Kopf des Berichts: „{}“ muss eine Liste von Abschnitten sein</translation>
    </message>
    <message>
        <source>the report has no such section; there are {}</source>
        <translation>diesen Abschnitt hat der Bericht nicht; es gibt {}</translation>
    </message>
    <message>
        <source>The report is written without it.</source>
        <translation>Der Bericht wird ohne dies geschrieben.</translation>
    </message>
    <message>
        <source>the logo '{}': {}</source>
        <translation>das Logo „{}“: {}</translation>
    </message>
    <message>
        <source>the logo '{}' is not in the archive</source>
        <translation>das Logo „{}“ ist nicht im Archiv</translation>
    </message>
    <message>
        <source>An archive reads itself alone: put the logo into it.</source>
        <translation>Ein Archiv liest nur sich selbst: das Logo hineinlegen.</translation>
    </message>
    <message>
        <source>the diagram of '{}' has no such text or picture any more</source>
        <translation>im Diagramm von „{}“ gibt es diesen Text oder dieses Bild nicht mehr</translation>
    </message>
    <message>
        <source>Choose it again: the text of the model has changed since.</source>
        <translation>Noch einmal auswählen: Der Modelltext hat sich seither geändert.</translation>
    </message>
    <message>
        <source>'{}' has no place for a text or a picture</source>
        <translation>„{}“ hat keinen Platz für einen Text oder ein Bild</translation>
    </message>
    <message>
        <source>what the diagram of '{}' shows is not written as a list</source>
        <translation>was das Diagramm von „{}“ zeigt, ist nicht als Liste geschrieben</translation>
    </message>
    <message>
        <source>Write it as 'graphics={{…}}'.</source>
        <translation>Als „graphics={{…}}“ schreiben.</translation>
    </message>
    <message>
        <source>'{}' is not a file</source>
        <translation>„{}“ ist keine Datei</translation>
    </message>
    <message>
        <source>'{}' is larger than 64 MB: make the picture smaller</source>
        <translation>„{}“ ist größer als 64 MB: das Bild verkleinern</translation>
    </message>
    <message>
        <source>'{}' cannot be read as a picture: PNG, JPEG and SVG can</source>
        <translation>„{}“ lässt sich nicht als Bild lesen; PNG, JPEG und SVG gehen</translation>
    </message>
    <message>
        <source>{} went from {:.4g} to {:.4g}</source>
        <translation>{} ging von {:.4g} nach {:.4g}</translation>
    </message>
    <message>
        <source>{}; the best until then is kept: {}</source>
        <translation>{}; das Beste bis dahin bleibt erhalten: {}</translation>
    </message>
</context>
<context>
    <name>Qt</name>
    <message>
        <source>Look in:</source>
        <translation>Suchen in:</translation>
    </message>
    <message>
        <source>File &amp;name:</source>
        <translation>Datei&amp;name:</translation>
    </message>
    <message>
        <source>File name:</source>
        <translation>Dateiname:</translation>
    </message>
    <message>
        <source>Files of type:</source>
        <translation>Dateien vom Typ:</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Ö&amp;ffnen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>&amp;Choose</source>
        <translation>&amp;Auswählen</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Go back</source>
        <translation>Zurückgehen</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vor</translation>
    </message>
    <message>
        <source>Go forward</source>
        <translation>Vorwärtsgehen</translation>
    </message>
    <message>
        <source>Parent Directory</source>
        <translation>Übergeordnetes Verzeichnis</translation>
    </message>
    <message>
        <source>Go to the parent directory</source>
        <translation>Zum übergeordneten Verzeichnis</translation>
    </message>
    <message>
        <source>Create New Folder</source>
        <translation>Neues Verzeichnis</translation>
    </message>
    <message>
        <source>Create a New Folder</source>
        <translation>Ein neues Verzeichnis anlegen</translation>
    </message>
    <message>
        <source>List View</source>
        <translation>Liste</translation>
    </message>
    <message>
        <source>Change to list view mode</source>
        <translation>Als Liste anzeigen</translation>
    </message>
    <message>
        <source>Detail View</source>
        <translation>Einzelheiten</translation>
    </message>
    <message>
        <source>Change to detail view mode</source>
        <translation>Mit Einzelheiten anzeigen</translation>
    </message>
    <message>
        <source>Directory:</source>
        <translation>Verzeichnis:</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Date Modified</source>
        <translation>Geändert</translation>
    </message>
    <message>
        <source>My Computer</source>
        <translation>Mein Computer</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>Computer</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Verzeichnis</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>%1 File</source>
        <translation>%1-Datei</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Laufwerk</translation>
    </message>
    <message>
        <source>Show </source>
        <translation>Anzeigen: </translation>
    </message>
    <message>
        <source>Save As</source>
        <translation>Speichern unter</translation>
    </message>
    <message>
        <source>Find Directory</source>
        <translation>Verzeichnis suchen</translation>
    </message>
    <message>
        <source>All Files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>%1 already exists.
Do you want to replace it?</source>
        <translation>%1 gibt es schon.
Soll die Datei ersetzt werden?</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Umbenennen</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Show &amp;hidden files</source>
        <translation>&amp;Versteckte Dateien anzeigen</translation>
    </message>
    <message>
        <source>&amp;New Folder</source>
        <translation>&amp;Neues Verzeichnis</translation>
    </message>
    <message>
        <source>New Folder</source>
        <translation>Neues Verzeichnis</translation>
    </message>
    <message>
        <source>Sidebar</source>
        <translation>Seitenleiste</translation>
    </message>
    <message>
        <source>List of places and bookmarks</source>
        <translation>Orte und Lesezeichen</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>%1
File not found.
Please verify the correct file name was given.</source>
        <translation>%1
Die Datei wurde nicht gefunden.
Bitte den Namen prüfen.</translation>
    </message>
    <message>
        <source>%1
Directory not found.
Please verify the correct directory name was given.</source>
        <translation>%1
Das Verzeichnis wurde nicht gefunden.
Bitte den Namen prüfen.</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Recent Places</source>
        <translation>Zuletzt besucht</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Save All</source>
        <translation>Alle speichern</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>&amp;Ja</translation>
    </message>
    <message>
        <source>Yes to &amp;All</source>
        <translation>Ja, &amp;alle</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>&amp;Nein</translation>
    </message>
    <message>
        <source>N&amp;o to All</source>
        <translation>N&amp;ein, keine</translation>
    </message>
    <message>
        <source>Abort</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Ignore</source>
        <translation>Ignorieren</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Restore Defaults</source>
        <translation>Vorgaben</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>Wieder&amp;herstellen</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>&amp;Ausschneiden</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>E&amp;infügen</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Alles auswählen</translation>
    </message>
    <message>
        <source>Copy &amp;Link Location</source>
        <translation>&amp;Verweisziel kopieren</translation>
    </message>
    <message>
        <source>&amp;Step up</source>
        <translation>&amp;Größer</translation>
    </message>
    <message>
        <source>Step &amp;down</source>
        <translation>&amp;Kleiner</translation>
    </message>
    <message>
        <source>Undo %1</source>
        <translation>Rückgängig: %1</translation>
    </message>
    <message>
        <source>Redo %1</source>
        <translation>Wiederherstellen: %1</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Float</source>
        <translation>Ablösen</translation>
    </message>
    <message>
        <source>Scroll here</source>
        <translation>Hierher rollen</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Left edge</source>
        <translation>Linker Rand</translation>
    </message>
    <message>
        <source>Right edge</source>
        <translation>Rechter Rand</translation>
    </message>
    <message>
        <source>Page up</source>
        <translation>Eine Seite nach oben</translation>
    </message>
    <message>
        <source>Page down</source>
        <translation>Eine Seite nach unten</translation>
    </message>
    <message>
        <source>Page left</source>
        <translation>Eine Seite nach links</translation>
    </message>
    <message>
        <source>Page right</source>
        <translation>Eine Seite nach rechts</translation>
    </message>
    <message>
        <source>Scroll up</source>
        <translation>Nach oben rollen</translation>
    </message>
    <message>
        <source>Scroll down</source>
        <translation>Nach unten rollen</translation>
    </message>
    <message>
        <source>Scroll left</source>
        <translation>Nach links rollen</translation>
    </message>
    <message>
        <source>Scroll right</source>
        <translation>Nach rechts rollen</translation>
    </message>
</context>
<context>
    <name>ValuesModel</name>
    <message>
        <source>The time of each sample</source>
        <translation>Die Zeit jedes Abtastwerts</translation>
    </message>
    <message>
        <source>As it stands in the file</source>
        <translation>Wie es in der Datei steht</translation>
    </message>
    <message>
        <source>What the model gets as %1</source>
        <translation>Was das Modell als %1 bekommt</translation>
    </message>
    <message>
        <source>Outside the range that is used</source>
        <translation>Außerhalb des verwendeten Bereichs</translation>
    </message>
</context>
<context>
    <name>ValuesPage</name>
    <message>
        <source>Reading</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>Reading …</source>
        <translation>Wird gelesen …</translation>
    </message>
    <message>
        <source>As in the file</source>
        <translation>Wie in der Datei</translation>
    </message>
    <message>
        <source>As the model gets them</source>
        <translation>Wie das Modell sie bekommt</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Every column of the file in its own unit</source>
        <translation>Jede Spalte der Datei in ihrer eigenen Einheit</translation>
    </message>
    <message>
        <source>Mapped columns in the unit of the model, scaled and shifted as the study says</source>
        <translation>Zugeordnete Spalten in der Einheit des Modells, skaliert und verschoben wie in der Studie</translation>
    </message>
    <message>
        <source>Values of the recording</source>
        <translation>Werte der Aufzeichnung</translation>
    </message>
    <message>
        <source>%1 · %2 samples, numbered by the lines of the file</source>
        <translation>%1 · %2 Abtastwerte, nummeriert nach den Zeilen der Datei</translation>
    </message>
</context>
<context>
    <name>SignalList</name>
    <message>
        <source>measured output %1</source>
        <translation>gemessener Ausgang %1</translation>
    </message>
    <message>
        <source>input %1</source>
        <translation>Eingang %1</translation>
    </message>
    <message>
        <source>not used by the model</source>
        <translation>vom Modell nicht benutzt</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Formulas</source>
        <translation>Formeln</translation>
    </message>
    <message>
        <source>worked out from other signals</source>
        <translation>aus anderen Signalen berechnet</translation>
    </message>
    <message>
        <source>Residuals</source>
        <translation>Residuen</translation>
    </message>
    <message>
        <source>measured less simulated, %1</source>
        <translation>gemessen minus simuliert, %1</translation>
    </message>
    <message>
        <source>Sensitivities</source>
        <translation>Empfindlichkeiten</translation>
    </message>
    <message>
        <source>how far %1 moves per relative change of %2, %3</source>
        <translation>wie weit sich %1 je relativer Änderung von %2 bewegt, %3</translation>
    </message>
</context>
<context>
    <name>SignalModel</name>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
</context>
<context>
    <name>SignalBrowser</name>
    <message>
        <source>Search name, unit, component, recording</source>
        <translation>Name, Einheit, Komponente, Aufzeichnung suchen</translation>
    </message>
    <message>
        <source>Variables of the model are simulated over this recording</source>
        <translation>Variablen des Modells werden über dieser Aufzeichnung simuliert</translation>
    </message>
    <message>
        <source>Nothing is called so.</source>
        <translation>Nichts heißt so.</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>Show the selected signals on one axis of the plots (Enter)</source>
        <translation>Die gewählten Signale auf einer Achse der Diagramme zeigen (Eingabetaste)</translation>
    </message>
    <message>
        <source>Formula, such as motor.v*motor.i</source>
        <translation>Formel, etwa motor.v*motor.i</translation>
    </message>
    <message>
        <source>A signal worked out from others, with + - * / ^, abs, sqrt, exp, log, sin, cos, min, max, der and integral; a name with spaces stands in 'single quotes'. Units follow.</source>
        <translation>Ein Signal, das aus anderen berechnet wird, mit + - * / ^, abs, sqrt, exp, log, sin, cos, min, max, der und integral; ein Name mit Leerzeichen steht in 'einfachen Anführungszeichen'. Die Einheiten ergeben sich.</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>%1 signals</source>
        <translation>%1 Signale</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Add formula %1</source>
        <translation>Formel %1 hinzufügen</translation>
    </message>
</context>
<context>
    <name>SignalStrip</name>
    <message>
        <source>Move this axis up (Alt+Up)</source>
        <translation>Diese Achse nach oben (Alt+Pfeil auf)</translation>
    </message>
    <message>
        <source>Move this axis down (Alt+Down)</source>
        <translation>Diese Achse nach unten (Alt+Pfeil ab)</translation>
    </message>
    <message>
        <source>Remove this axis (Del)</source>
        <translation>Diese Achse entfernen (Entf)</translation>
    </message>
    <message>
        <source>on its way …</source>
        <translation>wird geholt …</translation>
    </message>
    <message>
        <source>Δ %1, mean %2, rms %3</source>
        <translation>Δ %1, Mittel %2, Effektivwert %3</translation>
    </message>
    <message>
        <source>residual of %1</source>
        <translation>Residuum von %1</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>x-y</source>
        <translation>x-y</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>Coherence</source>
        <translation>Kohärenz</translation>
    </message>
    <message>
        <source>Histogram</source>
        <translation>Histogramm</translation>
    </message>
    <message>
        <source>Over the time, the others against the first signal, power spectral density (Welch), coherence with the first signal, or how often each value comes; of the part that is visible</source>
        <translation>Über der Zeit, die anderen über dem ersten Signal, Leistungsdichte (Welch), Kohärenz mit dem ersten Signal, oder wie oft jeder Wert vorkommt; des sichtbaren Teils</translation>
    </message>
</context>
<context>
    <name>SignalValues</name>
    <message>
        <source>Nothing is simulated of this output.</source>
        <translation>Von diesem Ausgang ist nichts simuliert.</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>Simulating %1</source>
        <translation>%1 wird simuliert</translation>
    </message>
    <message>
        <source>Sensitivities</source>
        <translation>Empfindlichkeiten</translation>
    </message>
</context>
<context>
    <name>PlotArea</name>
    <message>
        <source>Drag signals here, or press Enter on them in the list of signals. Several on one axis: choose them together, or drag them onto it.</source>
        <translation>Signale hierher ziehen oder in der Liste der Signale die Eingabetaste drücken. Mehrere auf einer Achse: zusammen wählen oder auf sie ziehen.</translation>
    </message>
    <message>
        <source>Plot %1</source>
        <translation>%1 zeichnen</translation>
    </message>
    <message>
        <source>Take %1 out of the plots</source>
        <translation>%1 aus den Diagrammen nehmen</translation>
    </message>
    <message>
        <source>Move an axis of the plots</source>
        <translation>Eine Achse der Diagramme verschieben</translation>
    </message>
    <message>
        <source>Remove an axis of the plots</source>
        <translation>Eine Achse der Diagramme entfernen</translation>
    </message>
    <message>
        <source>Between the cursors: %1 s to %2 s, %3 s</source>
        <translation>Zwischen den Marken: %1 s bis %2 s, %3 s</translation>
    </message>
    <message>
        <source>Change the view of an axis</source>
        <translation>Die Ansicht einer Achse ändern</translation>
    </message>
</context>
<context>
    <name>Knob</name>
    <message>
        <source>Drag: the traces show what the parameter does. Arrows step; so does the wheel once the slider has the focus.</source>
        <translation>Ziehen: die Kurven zeigen, was der Parameter bewirkt. Pfeile gehen in Schritten, ebenso das Mausrad, sobald der Regler den Fokus hat.</translation>
    </message>
    <message>
        <source>Simulating</source>
        <translation>Simulation</translation>
    </message>
</context>
<context>
    <name>Figure</name>
    <message>
        <source>Frequency [Hz]</source>
        <translation>Frequenz [Hz]</translation>
    </message>
    <message>
        <source>Power spectral density [unit²/Hz]</source>
        <translation>Leistungsdichte [Einheit²/Hz]</translation>
    </message>
    <message>
        <source>Coherence with %1</source>
        <translation>Kohärenz mit %1</translation>
    </message>
    <message>
        <source>Value, each in its own unit</source>
        <translation>Wert, jeder in seiner Einheit</translation>
    </message>
    <message>
        <source>Share of the samples</source>
        <translation>Anteil der Abtastwerte</translation>
    </message>
    <message>
        <source>This view needs two signals on the axis.</source>
        <translation>Diese Ansicht braucht zwei Signale auf der Achse.</translation>
    </message>
    <message>
        <source>Nothing to show yet.</source>
        <translation>Noch nichts zu zeigen.</translation>
    </message>
</context>
<context>
    <name>Chooser</name>
    <message>
        <source>Nothing is called “%1” or described so.</source>
        <translation>Nichts heißt „%1“ oder ist so beschrieben.</translation>
    </message>
</context>
<context>
    <name>FindBar</name>
    <message>
        <source>Find in the text</source>
        <translation>Im Text suchen</translation>
    </message>
    <message>
        <source>Previous (Shift+F3)</source>
        <translation>Vorheriges (Umschalt+F3)</translation>
    </message>
    <message>
        <source>Next (F3)</source>
        <translation>Nächstes (F3)</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>Schließen (Esc)</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>nicht gefunden</translation>
    </message>
</context>
<context>
    <name>WindowWords</name>
    <message>
        <source>Where channels have times of their own, say it at the import, under Several times.</source>
        <translation>Wo Kanäle eigene Zeiten haben, beim Import unter „Mehrere Zeiten“ sagen.</translation>
    </message>
    <message>
        <source>Nothing leads to {} yet: connect it, or write an equation for it.</source>
        <translation>Zu {} führt noch nichts: verbinden oder eine Gleichung dafür schreiben.</translation>
    </message>
    <message>
        <source>{}: {}; give its column a scale of -1, and search again</source>
        <translation>{}: {}; ihrer Spalte den Faktor -1 geben und erneut suchen</translation>
    </message>
    <message>
        <source>Say it at the import, as the form of the time: %j:%H:%M:%S or %H:%M:%S:%f.</source>
        <translation>Beim Einlesen als Form der Zeit sagen: %j:%H:%M:%S oder %H:%M:%S:%f.</translation>
    </message>
    <message>
        <source>Say it at the import, as the form of the time: {} or s.</source>
        <translation>Beim Einlesen als Form der Zeit sagen: {} oder s.</translation>
    </message>
    <message>
        <source>Use a part of the recordings (their range, or Trim above the traces), fewer of their columns or rows, a smaller model, or a machine with more memory.</source>
        <translation>Einen Teil der Aufzeichnungen verwenden (ihren Bereich, oder Zuschneiden über den Kurven), weniger ihrer Spalten oder Zeilen, ein kleineres Modell oder einen Rechner mit mehr Speicher.</translation>
    </message>
    <message>
        <source>Use a part of the recordings (their range, or Trim above the traces), or a smaller model.</source>
        <translation>Einen Teil der Aufzeichnungen verwenden (ihren Bereich, oder Zuschneiden über den Kurven) oder ein kleineres Modell.</translation>
    </message>
    <message>
        <source>Use a part of the recordings (their range, or Trim above the traces), fewer of their rows, or fewer outputs of the model.</source>
        <translation>Einen Teil der Aufzeichnungen verwenden (ihren Bereich, oder Zuschneiden über den Kurven), weniger ihrer Zeilen oder weniger Ausgänge des Modells.</translation>
    </message>
    <message>
        <source>Use a part of the recordings (their range, or Trim above the traces), fewer of their rows, or fit fewer parameters.</source>
        <translation>Einen Teil der Aufzeichnungen verwenden (ihren Bereich, oder Zuschneiden über den Kurven), weniger ihrer Zeilen, oder weniger Parameter anpassen.</translation>
    </message>
    <message>
        <source>{}: the start value of the model is another one</source>
        <translation>{}: Der Startwert des Modells ist ein anderer</translation>
    </message>
    <message>
        <source>no recording is used to fit</source>
        <translation>Keine Aufzeichnung dient der Anpassung</translation>
    </message>
    <message>
        <source>Give a recording that is used to fit a weight above 0 in the table of recordings.</source>
        <translation>Einer Aufzeichnung, die der Anpassung dient, in der Tabelle der Aufzeichnungen ein Gewicht über 0 geben.</translation>
    </message>
    <message>
        <source>it is set in the menu of the input {} among the measurements</source>
        <translation>zu setzen im Menü des Eingangs {} bei den Messungen</translation>
    </message>
    <message>
        <source>{}: {}; correct the unit in the header of the file, and search again</source>
        <translation>{}: {}; die Einheit im Kopf der Datei berichtigen und erneut suchen</translation>
    </message>
    <message>
        <source>the input '{}' is stamped {:.3g} s late ({:.2g} samples; a mean over the last sample is late by half of one): the search reckons with it, the errors that are reported do not; set the clock in the menu of the input among the measurements to {:.3g} s</source>
        <translation>Der Eingang „{}“ ist {:.3g} s zu spät gestempelt ({:.2g} Abtastwerte; ein Mittel über den letzten Abtastschritt ist um einen halben verspätet): Die Suche rechnet damit, die berichteten Fehler nicht; die Uhr im Menü des Eingangs bei den Messungen auf {:.3g} s setzen</translation>
    </message>
    <message>
        <source>'{}' does not begin where the model was told: what it begins with is estimated from it alone, and its errors are with that ({})</source>
        <translation>„{}“ beginnt nicht dort, wo es dem Modell gesagt ist: Womit es beginnt, wird aus ihm allein geschätzt, und seine Fehler gelten damit ({})</translation>
    </message>
    <message>
        <source>'{}' does not begin where the model was told: {} is {}{}{} there, not {:.5g}; it is fitted for this recording</source>
        <translation>„{}“ beginnt nicht dort, wo es dem Modell gesagt ist: {} ist dort {}{}{}, nicht {:.5g}; es wird für diese Aufzeichnung angepasst</translation>
    </message>
    <message>
        <source>what jumps has no slope: choose Straight between its samples in the menu of the input, or let the model filter it</source>
        <translation>Was springt, hat keine Steigung: im Menü des Eingangs „Gerade zwischen den Abtastwerten“ wählen, oder das Modell filtern lassen</translation>
    </message>
    <message>
        <source>Remove these rows, fill the cells, or leave them out with the range of the recording (or Trim above the traces).</source>
        <translation>Diese Zeilen entfernen, die Zellen füllen, oder sie mit dem Bereich der Aufzeichnung auslassen (oder mit Zuschneiden über den Kurven).</translation>
    </message>
    <message>
        <source>An input that is written only now and then is told how it runs between: Held or Straight between its samples, in its menu among the measurements.</source>
        <translation>Einem Eingang, der nur hin und wieder geschrieben wird, ist zu sagen, wie er dazwischen verläuft: gehalten oder gerade zwischen den Abtastwerten, in seinem Menü bei den Messungen.</translation>
    </message>
    <message>
        <source>Give the unit that its numbers are in in the header of the file: {} [unit].</source>
        <translation>Die Einheit, in der seine Zahlen stehen, im Kopf der Datei angeben: {} [Einheit].</translation>
    </message>
    <message>
        <source>Say which it is in the header of the file: {} [{}] or {} [{}].</source>
        <translation>Im Kopf der Datei sagen, welche es ist: {} [{}] oder {} [{}].</translation>
    </message>
    <message>
        <source>Where they are in another unit, give it in the header of the file: {} [unit].</source>
        <translation>Stehen sie in einer anderen Einheit, sie im Kopf der Datei angeben: {} [Einheit].</translation>
    </message>
    <message>
        <source>Map another column, or give the right unit in the header of the file: {} [unit].</source>
        <translation>Eine andere Spalte zuordnen, oder die richtige Einheit im Kopf der Datei angeben: {} [Einheit].</translation>
    </message>
    <message>
        <source>Between rows, inputs run linearly in '{}'. The range of the recording (or Trim above the traces) leaves a part out.</source>
        <translation>Zwischen Zeilen verlaufen Eingänge linear in „{}“. Der Bereich der Aufzeichnung (oder Zuschneiden über den Kurven) lässt einen Teil aus.</translation>
    </message>
    <message>
        <source>Map another column, or leave the channel out.</source>
        <translation>Eine andere Spalte zuordnen oder den Kanal auslassen.</translation>
    </message>
    <message>
        <source>Import the file again and choose the column of its stamps; or take channels of another group.</source>
        <translation>Die Datei erneut importieren und die Spalte ihrer Zeitstempel wählen; oder Kanäle einer anderen Gruppe nehmen.</translation>
    </message>
    <message>
        <source>An output is never resampled: take the raster of the outputs, or that of its own channel.</source>
        <translation>Ein Ausgang wird nie umgetastet: das Raster der Ausgänge nehmen, oder das seines eigenen Kanals.</translation>
    </message>
    <message>
        <source>Where that matters take its stamps: those of {}.</source>
        <translation>Wo das zählt, seine Zeitstempel nehmen: die von {}.</translation>
    </message>
    <message>
        <source>how a text is written has been told, and this is {}: it has no effect</source>
        <translation>Es ist angegeben, wie ein Text geschrieben ist, und dies ist {}: ohne Wirkung</translation>
    </message>
    <message>
        <source>Did the sensor or the logger stick? It is used as it stands; leave the part out with the range of the recording, or empty the cells of an output.</source>
        <translation>Hing der Sensor oder der Logger? Es wird verwendet, wie es ist; den Teil mit dem Bereich der Aufzeichnung auslassen, oder die Zellen eines Ausgangs leeren.</translation>
    </message>
    <message>
        <source>Say it at the import: the decimal sign is '{}' for {:.10g}, the sign between thousands is '{}' for {:.10g}.</source>
        <translation>Beim Import sagen: Dezimalzeichen „{}“ für {:.10g}, Tausenderzeichen „{}“ für {:.10g}.</translation>
    </message>
    <message>
        <source>the decimal sign and the sign between thousands are the same</source>
        <translation>Dezimalzeichen und Tausenderzeichen sind dasselbe</translation>
    </message>
    <message>
        <source>Split the file; or leave the first one out at the import: {} lines to skip.</source>
        <translation>Die Datei teilen; oder die erste beim Import auslassen: {} Zeilen zu überspringen.</translation>
    </message>
    <message>
        <source>Is it a measurement? If it is, say at the import how it is written: the separator, the decimal sign, the lines to skip before the header.</source>
        <translation>Ist es eine Messung? Wenn ja, beim Import sagen, wie sie geschrieben ist: Trennzeichen, Dezimalzeichen, Zeilen zu überspringen vor dem Kopf.</translation>
    </message>
    <message>
        <source>Where it is a charge, give the unit in the header of the file: [A.s].</source>
        <translation>Ist es eine Ladung, die Einheit im Kopf der Datei angeben: [A.s].</translation>
    </message>
    <message>
        <source>As inputs they are held from row to row with Held between its samples in the menu of the input.</source>
        <translation>Als Eingänge werden sie von Zeile zu Zeile gehalten mit „Zwischen den Abtastwerten gehalten“ im Menü des Eingangs.</translation>
    </message>
    <message>
        <source>Export the time with more digits, or tell the time between two rows at the import, as the form of the time: 0.001 s.</source>
        <translation>Die Zeit mit mehr Stellen exportieren, oder die Zeit zwischen zwei Zeilen beim Import als Form der Zeit sagen: 0.001 s.</translation>
    </message>
    <message>
        <source>Say how they are written at the import, as the form of the time: %d.%m.%Y %H:%M:%S.</source>
        <translation>Beim Import sagen, wie sie geschrieben sind, als Form der Zeit: %d.%m.%Y %H:%M:%S.</translation>
    </message>
    <message>
        <source>Write the time zone as Europe/Berlin, UTC or +02:00.</source>
        <translation>Die Zeitzone als Europe/Berlin, UTC oder +02:00 schreiben.</translation>
    </message>
    <message>
        <source>Tell how they are written at the import: form of the time and time zone.</source>
        <translation>Beim Import sagen, wie sie geschrieben sind: Form der Zeit und Zeitzone.</translation>
    </message>
    <message>
        <source>Say it at the import, as the form of the time: %d/%m/%Y %H:%M:%S or %m/%d/%Y %H:%M:%S.</source>
        <translation>Beim Import als Form der Zeit sagen: %d/%m/%Y %H:%M:%S oder %m/%d/%Y %H:%M:%S.</translation>
    </message>
    <message>
        <source>If it is summer time, tell the time zone of the clock at the import: Europe/Berlin; if it is not, UTC.</source>
        <translation>Ist es Sommerzeit, beim Import die Zeitzone der Uhr sagen: Europe/Berlin; wenn nicht, UTC.</translation>
    </message>
    <message>
        <source>Say it at the import, as the form of the time: %H:%M or %M:%S.</source>
        <translation>Beim Import als Form der Zeit sagen: %H:%M oder %M:%S.</translation>
    </message>
    <message>
        <source>The form of the time is written as %d.%m.%Y %H:%M:%S, or as the time between two rows: 0.001 s.</source>
        <translation>Die Form der Zeit wird als %d.%m.%Y %H:%M:%S geschrieben, oder als Zeit zwischen zwei Zeilen: 0.001 s.</translation>
    </message>
    <message>
        <source>how the file is written has an entry that is not known here: {}</source>
        <translation>In dem, wie die Datei geschrieben ist, ist eine Angabe hier nicht bekannt: {}</translation>
    </message>
    <message>
        <source>Tell the time between two rows at the import, as the form of the time: 0.001 s, or as a rate: 1 kHz.</source>
        <translation>Die Zeit zwischen zwei Zeilen beim Import als Form der Zeit sagen: 0.001 s, oder als Rate: 1 kHz.</translation>
    </message>
    <message>
        <source>Say it at the import, as the form of the time: s or d.</source>
        <translation>Beim Import als Form der Zeit sagen: s oder d.</translation>
    </message>
    <message>
        <source>The recording may have been started anew there: split the file before line {}, or use its first part alone (range {:.6g} … {:.6g} s). If the clock was set back, add {:.4g} s from there on. Sorting the rows would mix two recordings.</source>
        <translation>Die Aufzeichnung ist dort vielleicht neu begonnen worden: die Datei vor Zeile {} teilen, oder nur ihren ersten Teil verwenden (Bereich {:.6g} … {:.6g} s). Ist die Uhr zurückgestellt worden, ab dort {:.4g} s addieren. Die Zeilen zu sortieren würde zwei Aufzeichnungen mischen.</translation>
    </message>
    <message>
        <source>Give one among the parameters, or in the model.</source>
        <translation>Einen bei den Parametern angeben, oder im Modell.</translation>
    </message>
    <message>
        <source>Widen the bounds among the parameters, or do not fit it.</source>
        <translation>Die Grenzen bei den Parametern erweitern, oder ihn nicht anpassen.</translation>
    </message>
    <message>
        <source>Widen the bounds, or give another value among the parameters.</source>
        <translation>Die Grenzen erweitern, oder bei den Parametern einen anderen Wert angeben.</translation>
    </message>
    <message>
        <source>Start above 0: give another value among the parameters.</source>
        <translation>Über 0 beginnen: bei den Parametern einen anderen Wert angeben.</translation>
    </message>
    <message>
        <source>Set the clock of the output among the measurements to fit.</source>
        <translation>Die Uhr des Ausgangs bei den Messungen auf anpassen setzen.</translation>
    </message>
    <message>
        <source>Set the check box of a recording among the measurements.</source>
        <translation>Bei den Messungen den Haken einer Aufzeichnung setzen.</translation>
    </message>
    <message>
        <source>Say which {} it is: drag its column onto the signal among the measurements. Its groups: {}.</source>
        <translation>Sagen, welcher Kanal „{}“ es ist: seine Spalte bei den Messungen auf das Signal ziehen. Seine Gruppen: {}.</translation>
    </message>
    <message>
        <source>It holds words. If they are stamps of the time, tell how they are written at the import, as the form of the time: %d.%m.%Y %H:%M:%S.</source>
        <translation>Es enthält Wörter. Sind es Zeitstempel, beim Import sagen, wie sie geschrieben sind, als Form der Zeit: %d.%m.%Y %H:%M:%S.</translation>
    </message>
    <message>
        <source>Import the file again and choose its time column.</source>
        <translation>Die Datei erneut importieren und ihre Zeitspalte wählen.</translation>
    </message>
    <message>
        <source>It is an output of the model: take its column from the input, and map it there.</source>
        <translation>Es ist ein Ausgang des Modells: seine Spalte dem Eingang nehmen und dort zuordnen.</translation>
    </message>
    <message>
        <source>It is an input of the model: take its column from the output, and map it there.</source>
        <translation>Es ist ein Eingang des Modells: seine Spalte dem Ausgang nehmen und dort zuordnen.</translation>
    </message>
    <message>
        <source>Drag a column onto {} among the measurements. {}</source>
        <translation>Bei den Messungen eine Spalte auf {} ziehen. {}</translation>
    </message>
    <message>
        <source>Write the model, or take its text into the directory of the study as model.mo.</source>
        <translation>Das Modell schreiben, oder seinen Text als model.mo in das Verzeichnis der Studie legen.</translation>
    </message>
    <message>
        <source>Check parameters in the list of parameters.</source>
        <translation>In der Liste der Parameter Haken setzen.</translation>
    </message>
    <message>
        <source>Choose Held between its samples in its menu there, too, or Straight where it is meant.</source>
        <translation>Auch dort in seinem Menü „Zwischen den Abtastwerten gehalten“ wählen, oder gerade, wo es so gemeint ist.</translation>
    </message>
    <message>
        <source>this archive holds no study</source>
        <translation>Dieses Archiv enthält keine Studie</translation>
    </message>
    <message>
        <source>Choose a file that was saved as a study.</source>
        <translation>Eine Datei wählen, die als Studie gespeichert wurde.</translation>
    </message>
    <message>
        <source>Choose a study file, or the directory of a study.</source>
        <translation>Eine Studiendatei wählen, oder das Verzeichnis einer Studie.</translation>
    </message>
    <message>
        <source>this directory holds no study</source>
        <translation>Dieses Verzeichnis enthält keine Studie</translation>
    </message>
    <message>
        <source>Choose a directory that was saved as a study.</source>
        <translation>Ein Verzeichnis wählen, das als Studie gespeichert wurde.</translation>
    </message>
    <message>
        <source>the path of the measurement cannot be kept in the study: {}</source>
        <translation>Der Pfad der Messung lässt sich in der Studie nicht festhalten: {}</translation>
    </message>
    <message>
        <source>the search was ended after {:.0f} times the work of the fit of the model as given, and says what it had until then; Search ten times as long, in the result and in the menu Run, goes on</source>
        <translation>die Suche wurde nach dem {}-fachen der Arbeit für die Anpassung des gegebenen Modells beendet und sagt, was sie bis dahin hatte; „Zehnmal so lange suchen“, im Ergebnis und im Menü „Rechnen“, geht weiter</translation>
    </message>
</context>
<context>
    <name>RecordingsModel</name>
    <message>
        <source>the simulation stops at %1 s</source>
        <translation>die Simulation endet bei %1 s</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>anpassen</translation>
    </message>
    <message>
        <source>validate</source>
        <translation>validieren</translation>
    </message>
    <message>
        <source>Left out until this is mended:</source>
        <translation>Ausgelassen, bis dies behoben ist:</translation>
    </message>
    <message>
        <source>Clear the check box to leave the recording out of all work</source>
        <translation>Haken entfernen, um die Aufzeichnung überall auszulassen</translation>
    </message>
    <message>
        <source>Left out of all work; set the check box to take it in</source>
        <translation>Überall ausgelassen; Haken setzen, um sie einzubeziehen</translation>
    </message>
    <message>
        <source>Used to fit and to choose effects</source>
        <translation>Dient zum Anpassen und zum Wählen von Effekten</translation>
    </message>
    <message>
        <source>Only reported; never used to fit or to choose</source>
        <translation>Wird nur berichtet; nie zum Anpassen oder Wählen verwendet</translation>
    </message>
    <message>
        <source>How much each output of the recording counts in a fit beside those of others: 1 is the common weight, 0 leaves it out</source>
        <translation>Wie viel jeder Ausgang der Aufzeichnung bei einer Anpassung neben denen anderer zählt: 1 ist das übliche Gewicht, 0 lässt ihn aus</translation>
    </message>
    <message>
        <source>Error of this output in the present run, before → after, in % of its range</source>
        <translation>Fehler dieses Ausgangs im gezeigten Lauf, vorher → nachher, in % seiner Spanne</translation>
    </message>
    <message>
        <source>Error %1</source>
        <translation>Fehler %1</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Mangel</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Abtastwerte</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>%1 recordings</source>
        <translation>%1 Aufzeichnungen</translation>
    </message>
    <message>
        <source>Take %1 in</source>
        <translation>%1 einbeziehen</translation>
    </message>
    <message>
        <source>Leave %1 out</source>
        <translation>%1 auslassen</translation>
    </message>
    <message>
        <source>Use %1 to fit</source>
        <translation>%1 zur Anpassung verwenden</translation>
    </message>
    <message>
        <source>Use %1 to validate</source>
        <translation>%1 zur Validierung verwenden</translation>
    </message>
    <message>
        <source>Weigh %1</source>
        <translation>%1 gewichten</translation>
    </message>
</context>
<context>
    <name>RecordingsPage</name>
    <message>
        <source>Recordings</source>
        <translation>Aufzeichnungen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Space takes the marked rows in or out. Role and weight are edited in their cells.</source>
        <translation>Leertaste: markierte Zeilen ein oder aus. Rolle und Gewicht ändert man in ihrer Zelle.</translation>
    </message>
    <message>
        <source>Fit the marked</source>
        <translation>Markierte anpassen</translation>
    </message>
    <message>
        <source>Fit the marked (%1)</source>
        <translation>Markierte anpassen (%1)</translation>
    </message>
    <message>
        <source>Search in the marked</source>
        <translation>In Markierten suchen</translation>
    </message>
    <message>
        <source>Search in the marked (%1)</source>
        <translation>In Markierten suchen (%1)</translation>
    </message>
    <message>
        <source>Mark rows first: Ctrl and Shift with a click or an arrow, Ctrl+A for all</source>
        <translation>Zuerst Zeilen markieren: Strg und Umschalt mit Klick oder Pfeil, Strg+A für alle</translation>
    </message>
    <message>
        <source>None of the marked recordings is used and there to fit</source>
        <translation>Keine der markierten Aufzeichnungen wird verwendet und dient der Anpassung</translation>
    </message>
    <message>
        <source>A run is under way</source>
        <translation>Ein Lauf ist im Gang</translation>
    </message>
    <message>
        <source>Estimate the checked parameters from these recordings alone</source>
        <translation>Die angehakten Parameter aus diesen Aufzeichnungen allein schätzen</translation>
    </message>
    <message>
        <source>Find the effect that the model lacks in these recordings alone</source>
        <translation>In diesen Aufzeichnungen allein den Effekt finden, der dem Modell fehlt</translation>
    </message>
    <message>
        <source>Take the marked in</source>
        <translation>Markierte einbeziehen</translation>
    </message>
    <message>
        <source>Leave the marked out</source>
        <translation>Markierte auslassen</translation>
    </message>
    <message>
        <source>Use the marked to fit</source>
        <translation>Markierte zur Anpassung verwenden</translation>
    </message>
    <message>
        <source>Use the marked to validate</source>
        <translation>Markierte zur Validierung verwenden</translation>
    </message>
    <message>
        <source>Show the values</source>
        <translation>Werte zeigen</translation>
    </message>
    <message>
        <source>Locate the file …</source>
        <translation>Datei suchen …</translation>
    </message>
    <message>
        <source>Sort by %1</source>
        <translation>Nach %1 sortieren</translation>
    </message>
</context>
<context>
    <name>StopField</name>
    <message>
        <source>Simulate until</source>
        <translation>Simulieren bis</translation>
    </message>
    <message>
        <source>When a simulation of the model by itself (F4) ends, in seconds; it is kept in the model's text</source>
        <translation>Wann eine Simulation des Modells für sich (F4) endet, in Sekunden; es bleibt im Text des Modells</translation>
    </message>
    <message>
        <source>Set the stop time</source>
        <translation>Endzeit setzen</translation>
    </message>
</context>
<context>
    <name>PracticeDialog</name>
    <message>
        <source>Record</source>
        <translation>Aufzeichnen</translation>
    </message>
    <message>
        <source>Record as measurement</source>
        <translation>Als Messung aufzeichnen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>The same number gives the same noise</source>
        <translation>Dieselbe Zahl gibt dasselbe Rauschen</translation>
    </message>
    <message>
        <source>Sample time</source>
        <translation>Abtastzeit</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Choose where the file goes</source>
        <translation>Wählen, wohin die Datei kommt</translation>
    </message>
    <message>
        <source>Sample time [s]</source>
        <translation>Abtastzeit [s]</translation>
    </message>
    <message>
        <source>Seed of the noise</source>
        <translation>Startwert des Rauschens</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Ausgang</translation>
    </message>
    <message>
        <source>Noise (standard deviation)</source>
        <translation>Rauschen (Standardabweichung)</translation>
    </message>
    <message>
        <source>Noise of each output</source>
        <translation>Rauschen jedes Ausgangs</translation>
    </message>
    <message>
        <source>Where the recording goes</source>
        <translation>Wohin die Aufzeichnung kommt</translation>
    </message>
    <message>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
    </message>
    <message>
        <source>The sample time is a number of seconds above 0.</source>
        <translation>Die Abtastzeit ist eine Zahl von Sekunden über 0.</translation>
    </message>
    <message>
        <source>The noise of %1 is a number, 0 or above.</source>
        <translation>Das Rauschen von %1 ist eine Zahl, 0 oder darüber.</translation>
    </message>
    <message>
        <source>Simulate the model first (F4).</source>
        <translation>Zuerst das Modell simulieren (F4).</translation>
    </message>
    <message>
        <source>Give the file a name.</source>
        <translation>Der Datei einen Namen geben.</translation>
    </message>
    <message>
        <source>There is no folder %1.</source>
        <translation>Es gibt keinen Ordner %1.</translation>
    </message>
    <message>
        <source>There is a file of that name already: choose another one.</source>
        <translation>Eine Datei dieses Namens gibt es schon: einen anderen wählen.</translation>
    </message>
    <message>
        <source>The file becomes a recording of the study, to fit from.</source>
        <translation>Die Datei wird eine Aufzeichnung der Studie, an die angepasst wird.</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnen</translation>
    </message>
    <message>
        <source>Record %1</source>
        <translation>%1 aufzeichnen</translation>
    </message>
</context>
<context>
    <name>CommonUnits</name>
    <message>
        <source>%1 is no unit that is known.</source>
        <translation>%1 ist keine bekannte Einheit.</translation>
    </message>
    <message>
        <source>Did you mean %1?</source>
        <translation>Ist %1 gemeint?</translation>
    </message>
</context>
<context>
    <name>SensitivityPage</name>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Correlation of the parameters</source>
        <translation>Korrelation der Parameter</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>Empfindlichkeit</translation>
    </message>
    <message>
        <source>per relative change of a parameter</source>
        <translation>je relativer Änderung eines Parameters</translation>
    </message>
    <message>
        <source>per standard error of a parameter</source>
        <translation>je Standardfehler eines Parameters</translation>
    </message>
    <message>
        <source>Working out the sensitivities …</source>
        <translation>Empfindlichkeiten werden berechnet …</translation>
    </message>
    <message>
        <source>Sensitivities</source>
        <translation>Empfindlichkeiten</translation>
    </message>
    <message>
        <source>At the fitted values.</source>
        <translation>Bei den angepassten Werten.</translation>
    </message>
    <message>
        <source>At the present values.</source>
        <translation>Bei den gegenwärtigen Werten.</translation>
    </message>
    <message>
        <source>Correlation of the estimates: near 1 or −1, the recordings tell the two hardly apart.</source>
        <translation>Korrelation der Schätzwerte: Nahe 1 oder −1 unterscheiden die Aufzeichnungen die beiden kaum.</translation>
    </message>
    <message>
        <source>Standard error</source>
        <translation>Standardfehler</translation>
    </message>
    <message>
        <source>rms %1</source>
        <translation>Effektivwert %1</translation>
    </message>
    <message>
        <source>The slope of the trace times the value of each parameter, or times its standard error</source>
        <translation>Die Steigung der Kurve mal dem Wert jedes Parameters oder mal seinem Standardfehler</translation>
    </message>
</context>
<context>
    <name>analogon::ui::NamePopup</name>
    <message>
        <source>Names that fit</source>
        <translation>Passende Namen</translation>
    </message>
</context>
<context>
    <name>analogon::ui::SweepDialog</name>
    <message>
        <source>This could not be set: the messages say why.</source>
        <translation>Das ließ sich nicht setzen: Die Meldungen sagen, warum.</translation>
    </message>
    <message>
        <source>Sweep of parameters</source>
        <translation>Parameter durchfahren</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>The error of the fitted recordings at each value; nothing is fitted, and the study stays.</source>
        <translation>Der Fehler der angepassten Aufzeichnungen bei jedem Wert; nichts wird angepasst, und die Studie bleibt, wie sie ist.</translation>
    </message>
    <message>
        <source>by equal factors</source>
        <translation>in gleichen Faktoren</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Second parameter</source>
        <translation>Zweiter Parameter</translation>
    </message>
    <message>
        <source>(none)</source>
        <translation>(keiner)</translation>
    </message>
    <message>
        <source>Simulating …</source>
        <translation>Simulation läuft …</translation>
    </message>
    <message>
        <source>Stopped after %1 of %2 simulations.</source>
        <translation>Angehalten nach %1 von %2 Simulationen.</translation>
    </message>
    <message>
        <source>The model cannot be simulated at any of these values.</source>
        <translation>Das Modell lässt sich bei keinem dieser Werte simulieren.</translation>
    </message>
    <message>
        <source>Least error %1 at %2.</source>
        <translation>Kleinster Fehler %1 bei %2.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Simulate</source>
        <translation>Simulieren</translation>
    </message>
    <message>
        <source>The stronger the colour, the smaller the error.</source>
        <translation>Je kräftiger die Farbe, desto kleiner der Fehler.</translation>
    </message>
    <message>
        <source>A click sets what is there.</source>
        <translation>Ein Klick stellt ein, was dort gilt.</translation>
    </message>
    <message>
        <source>%1. %2. Enter sets this.</source>
        <translation>%1. %2. Die Eingabetaste stellt das ein.</translation>
    </message>
    <message>
        <source>Set: %1. %2. Undo takes it back.</source>
        <translation>Eingestellt: %1. %2. Rückgängig nimmt es zurück.</translation>
    </message>
    <message>
        <source>Set %1</source>
        <translation>%1 einstellen</translation>
    </message>
</context>
<context>
    <name>analogon::ui::SweepChart</name>
    <message>
        <source>Error over the parameters</source>
        <translation>Fehler über den Parametern</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Error %1</source>
        <translation>Fehler %1</translation>
    </message>
    <message>
        <source>Not simulated</source>
        <translation>Nicht simuliert</translation>
    </message>
    <message>
        <source>Click to set this</source>
        <translation>Klicken stellt das ein</translation>
    </message>
</context>
<context>
    <name>analogon::ui::MainWindow</name>
    <message>
        <source>Sweep of parameters …</source>
        <translation>Parameter durchfahren …</translation>
    </message>
    <message>
        <source>Profile of the likelihood …</source>
        <translation>Profil der Likelihood …</translation>
    </message>
    <message>
        <source>How far a fitted parameter may be from its estimate, all others fitted anew</source>
        <translation>Wie weit ein angepasster Parameter von seinem Schätzwert liegen darf, alle anderen neu angepasst</translation>
    </message>
    <message>
        <source>The error over one parameter as a curve, over two as a map</source>
        <translation>Der Fehler über einem Parameter als Kurve, über zweien als Karte</translation>
    </message>
</context>
<context>
    <name>analogon::ui::RecordingsPage</name>
    <message>
        <source>Filter</source>
        <translation>Filtern</translation>
    </message>
    <message>
        <source>Filter the recordings</source>
        <translation>Aufzeichnungen filtern</translation>
    </message>
</context>
<context>
    <name>CampaignWindow</name>
    <message>
        <source>, about %1 s left</source>
        <translation>, noch etwa %1 s</translation>
    </message>
    <message>
        <source>, about %1 min left</source>
        <translation>, noch etwa %1 min</translation>
    </message>
    <message>
        <source>, about %1 h left</source>
        <translation>, noch etwa %1 h</translation>
    </message>
    <message>
        <source>Units of the campaign</source>
        <translation>Exemplare der Kampagne</translation>
    </message>
    <message>
        <source>On a Slurm cluster, with the options</source>
        <translation>Auf einem Slurm-Cluster, mit den Optionen</translation>
    </message>
    <message>
        <source>Failed units again</source>
        <translation>Fehlgeschlagene erneut</translation>
    </message>
    <message>
        <source>Open its study</source>
        <translation>Studie öffnen</translation>
    </message>
    <message>
        <source>Open its report</source>
        <translation>Bericht öffnen</translation>
    </message>
    <message>
        <source>Open the summary</source>
        <translation>Zusammenfassung öffnen</translation>
    </message>
    <message>
        <source>Open the table of results</source>
        <translation>Ergebnistabelle öffnen</translation>
    </message>
    <message>
        <source>Campaign</source>
        <translation>Kampagne</translation>
    </message>
    <message>
        <source>Open a campaign.json: it names a study, and a table with a row for each unit</source>
        <translation>Eine campaign.json öffnen: Sie nennt eine Studie und eine Tabelle mit einer Zeile je Exemplar</translation>
    </message>
    <message>
        <source>Open …</source>
        <translation>Öffnen …</translation>
    </message>
    <message>
        <source>Results in</source>
        <translation>Ergebnisse in</translation>
    </message>
    <message>
        <source>Choose …</source>
        <translation>Wählen …</translation>
    </message>
    <message>
        <source>Units at the same time</source>
        <translation>Exemplare gleichzeitig</translation>
    </message>
    <message>
        <source>Options for sbatch</source>
        <translation>Optionen für sbatch</translation>
    </message>
    <message>
        <source>&amp;Units at the same time</source>
        <translation>&amp;Exemplare gleichzeitig</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtern</translation>
    </message>
    <message>
        <source>Filter the units</source>
        <translation>Die Exemplare filtern</translation>
    </message>
    <message>
        <source>Open a campaign</source>
        <translation>Kampagne öffnen</translation>
    </message>
    <message>
        <source>Campaigns (*.json);;All files (*)</source>
        <translation>Kampagnen (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Directory of the results</source>
        <translation>Verzeichnis der Ergebnisse</translation>
    </message>
    <message>
        <source>Reading …</source>
        <translation>Wird gelesen …</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>Campaign: %1</source>
        <translation>Kampagne: %1</translation>
    </message>
    <message>
        <source>Looking</source>
        <translation>Nachsehen</translation>
    </message>
    <message>
        <source>%1 units: %2 done, %3 failed, %4 waiting</source>
        <translation>%1 Exemplare: %2 fertig, %3 fehlgeschlagen, %4 wartend</translation>
    </message>
    <message>
        <source>, %1 running</source>
        <translation>, %1 in Arbeit</translation>
    </message>
    <message>
        <source>%1. Start goes on where it was.</source>
        <translation>%1. „Starten“ setzt die Kampagne fort, wo sie war.</translation>
    </message>
    <message>
        <source>The campaign was stopped. Start goes on where it was.</source>
        <translation>Die Kampagne wurde angehalten. „Starten“ setzt sie fort, wo sie war.</translation>
    </message>
    <message>
        <source>All units failed; their rows say why.</source>
        <translation>Alle Exemplare sind fehlgeschlagen; ihre Zeilen sagen, warum.</translation>
    </message>
    <message>
        <source>The program that works on the campaign has ended unexpectedly. Start goes on where it was.</source>
        <translation>Das Programm, das an der Kampagne arbeitet, hat unerwartet geendet. „Starten“ setzt sie fort, wo sie war.</translation>
    </message>
    <message>
        <source>Stopping …</source>
        <translation>Wird angehalten …</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Starten</translation>
    </message>
    <message>
        <source>The job stays on the cluster when this window is closed; starting the campaign again follows it. Close it?</source>
        <translation>Der Auftrag bleibt auf dem Cluster, wenn dieses Fenster geschlossen wird; wird die Kampagne wieder gestartet, folgt sie ihm. Schließen?</translation>
    </message>
    <message>
        <source>The campaign stops when this window is closed; what is done is kept, and starting it again goes on. Close it?</source>
        <translation>Die Kampagne hält an, wenn dieses Fenster geschlossen wird; was fertig ist, bleibt, und ein neuer Start setzt sie fort. Schließen?</translation>
    </message>
</context>
<context>
    <name>CampaignProcess</name>
    <message>
        <source>The program analogon-cli, which works on campaigns, was found neither beside this one nor among those that are installed.</source>
        <translation>Das Programm analogon-cli, das an Kampagnen arbeitet, wurde weder neben diesem noch unter den installierten gefunden.</translation>
    </message>
</context>
<context>
    <name>UnitsModel</name>
    <message>
        <source>waiting</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>running</source>
        <translation>in Arbeit</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fehlgeschlagen</translation>
    </message>
    <message>
        <source>nothing is missing</source>
        <translation>nichts fehlt</translation>
    </message>
    <message>
        <source>unexplained</source>
        <translation>unerklärt</translation>
    </message>
    <message>
        <source>in part</source>
        <translation>zum Teil</translation>
    </message>
    <message>
        <source> at </source>
        <translation> an </translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Exemplar</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stand</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Gefunden</translation>
    </message>
    <message>
        <source>Before [%]</source>
        <translation>Vorher [%]</translation>
    </message>
    <message>
        <source>After [%]</source>
        <translation>Nachher [%]</translation>
    </message>
    <message>
        <source>Time [s]</source>
        <translation>Zeit [s]</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Fehler</translation>
    </message>
</context>
<context>
    <name>ReportFolderDialog</name>
    <message>
        <source>Directory:</source>
        <translation>Verzeichnis:</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Schreiben</translation>
    </message>
</context>
<context>
    <name>ProfileDialog</name>
    <message>
        <source>Profile of the likelihood</source>
        <translation>Profil der Likelihood</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Fitting the others at each value …</source>
        <translation>Die anderen werden bei jedem Wert angepasst …</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Angehalten.</translation>
    </message>
    <message>
        <source>Fit the parameters first (F5).</source>
        <translation>Zuerst die Parameter anpassen (F5).</translation>
    </message>
    <message>
        <source>How much worse the fit becomes where the parameter is held at other values and all others are fitted anew.</source>
        <translation>Um wie viel schlechter die Anpassung wird, wenn der Parameter auf anderen Werten festgehalten und alle anderen neu angepasst werden.</translation>
    </message>
    <message>
        <source>The recordings limit %1 on no side between %2 and %3.</source>
        <translation>Die Aufzeichnungen begrenzen %1 zwischen %2 und %3 auf keiner Seite.</translation>
    </message>
    <message>
        <source>95 % interval of %1: up to %3; the recordings set no lower limit down to %2.</source>
        <translation>95-%-Intervall von %1: bis %3; nach unten setzen die Aufzeichnungen bis %2 keine Grenze.</translation>
    </message>
    <message>
        <source>95 % interval of %1: from %2; the recordings set no upper limit up to %3.</source>
        <translation>95-%-Intervall von %1: ab %2; nach oben setzen die Aufzeichnungen bis %3 keine Grenze.</translation>
    </message>
    <message>
        <source>95 % interval of %1: from %2 to %3.</source>
        <translation>95-%-Intervall von %1: von %2 bis %3.</translation>
    </message>
    <message>
        <source>Fall of twice the log-likelihood</source>
        <translation>Abfall der doppelten Log-Likelihood</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>Estimate</source>
        <translation>Schätzwert</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Work it out</source>
        <translation>Berechnen</translation>
    </message>
</context>
<context>
    <name>LibraryPackage</name>
    <message>
        <source>Interfaces</source>
        <translation>Anschlüsse</translation>
    </message>
    <message>
        <source>Mechanics</source>
        <translation>Drehende Mechanik</translation>
    </message>
    <message>
        <source>Translation</source>
        <translation>Geradlinige Mechanik</translation>
    </message>
    <message>
        <source>ElectricMechanical</source>
        <translation>Elektrisch-mechanisch</translation>
    </message>
    <message>
        <source>ElectricThermal</source>
        <translation>Elektrisch-thermisch</translation>
    </message>
    <message>
        <source>ThermalFluid</source>
        <translation>Thermisch-fluidisch</translation>
    </message>
    <message>
        <source>MechanicThermal</source>
        <translation>Mechanisch-thermisch</translation>
    </message>
    <message>
        <source>Thermal</source>
        <translation>Wärme</translation>
    </message>
    <message>
        <source>Electric</source>
        <translation>Elektrik</translation>
    </message>
    <message>
        <source>Sources</source>
        <translation>Quellen</translation>
    </message>
    <message>
        <source>Sensors</source>
        <translation>Sensoren</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signale</translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>Tabellen</translation>
    </message>
    <message>
        <source>Effects</source>
        <translation>Effekte</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Messkanäle</translation>
    </message>
    <message>
        <source>Actuator</source>
        <translation>Eingangskanäle</translation>
    </message>
</context>
</TS>
