<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>BlockItem</name>
    <message>
        <source>This class is not known.</source>
        <translation>Diese Klasse ist nicht bekannt.</translation>
    </message>
</context>
<context>
    <name>ComposeActions</name>
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
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Anpassen</translation>
    </message>
    <message>
        <source>Validate</source>
        <translation>Validierung</translation>
    </message>
    <message>
        <source>First</source>
        <translation>Erster</translation>
    </message>
    <message>
        <source>Second</source>
        <translation>Zweiter</translation>
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
        <source>plain squares</source>
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
        <source>Comparison of two runs</source>
        <translation>Vergleich zweier Läufe</translation>
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
        <source>Every fit and discovery is kept here.</source>
        <translation>Jede Anpassung und jede Suche bleibt hier erhalten.</translation>
    </message>
    <message>
        <source>Choose two runs to compare them.</source>
        <translation>Zwei Läufe wählen, um sie zu vergleichen.</translation>
    </message>
    <message>
        <source>error, fit</source>
        <translation>Fehler, Anpassung</translation>
    </message>
    <message>
        <source>error, validate</source>
        <translation>Fehler, Validierung</translation>
    </message>
</context>
<context>
    <name>GeneratePage</name>
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
        <source>Add to the study</source>
        <translation>Zur Studie hinzufügen</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
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
        <source>point</source>
        <translation>Punkt</translation>
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
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>Used to</source>
        <translation>Dient zum</translation>
    </message>
    <message>
        <source>Time column</source>
        <translation>Zeitspalte</translation>
    </message>
    <message>
        <source>Separator</source>
        <translation>Trennzeichen</translation>
    </message>
    <message>
        <source>Decimal sign</source>
        <translation>Dezimalzeichen</translation>
    </message>
    <message>
        <source>Row of units</source>
        <translation>Einheitenzeile</translation>
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
        <translation>Wärmeverlust an eine konstante Umgebung unbekannter Temperatur</translation>
    </message>
    <message>
        <source>Heat loss to surroundings whose temperature was recorded</source>
        <translation>Wärmeverlust an eine Umgebung, deren Temperatur aufgezeichnet wurde</translation>
    </message>
    <message>
        <source>Radiation to constant surroundings of unknown temperature</source>
        <translation>Strahlung an eine konstante Umgebung unbekannter Temperatur</translation>
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
        <source>Torque that grows with the third power of speed</source>
        <translation>Drehmoment mit der dritten Potenz der Drehzahl</translation>
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
        <source>Torque that repeats in time</source>
        <translation>Periodisches Drehmoment</translation>
    </message>
    <message>
        <source>End stop at a small angle</source>
        <translation>Anschlag bei kleinem Winkel</translation>
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
        <translation>Mechanik</translation>
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
        <source>Body with heat capacity in a stream (convection by the fluid temperature, eq. 8)</source>
        <translation>Körper mit Wärmekapazität in einer Strömung</translation>
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
        <translation>Einen Block auf das Diagramm ziehen oder auswählen und Eingabe drücken.</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
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
        <source>Not saved: see the messages.</source>
        <translation>Nicht gespeichert: siehe Meldungen.</translation>
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
        <source>Measurements (*.csv *.txt *.tsv *.dat *.mf4 *.mdf *.mat)</source>
        <translation>Messungen (*.csv *.txt *.tsv *.dat *.mf4 *.mdf *.mat)</translation>
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
        <source>Writing the report</source>
        <translation>Bericht schreiben</translation>
    </message>
    <message>
        <source>Report written to %1/report.html.</source>
        <translation>Bericht in %1/report.html geschrieben.</translation>
    </message>
    <message>
        <source>No report written: see the messages.</source>
        <translation>Kein Bericht geschrieben: siehe Meldungen.</translation>
    </message>
</context>
<context>
    <name>MeasurementPanel</name>
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
</context>
<context>
    <name>MessagePanel</name>
    <message>
        <source>No messages.</source>
        <translation>Keine Meldungen.</translation>
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
</context>
<context>
    <name>ParameterModel</name>
    <message>
        <source>at min</source>
        <translation>am Minimum</translation>
    </message>
    <message>
        <source>at max</source>
        <translation>am Maximum</translation>
    </message>
    <message>
        <source>  not determined</source>
        <translation>  nicht bestimmt</translation>
    </message>
    <message>
        <source>
The fit ran into the bound: it wants a value beyond. Widen the bound, or ask what the model lacks.</source>
        <translation>
Die Anpassung stößt an die Grenze: Sie will darüber hinaus. Grenze weiten, oder fragen, was dem Modell fehlt.</translation>
    </message>
    <message>
        <source>
The data do not determine this value on its own.</source>
        <translation>
Die Daten allein bestimmen diesen Wert nicht.</translation>
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
        <source>In bounds</source>
        <translation>In Grenzen</translation>
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
</context>
<context>
    <name>ParameterPanel</name>
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
        <source>No parameters to show. See the messages if the model could not be read.</source>
        <translation>Keine Parameter zu zeigen. Konnte das Modell nicht gelesen werden, sagen die Meldungen, warum.</translation>
    </message>
</context>
<context>
    <name>PlotPanel</name>
    <message>
        <source>best so far</source>
        <translation>bisher bester Stand</translation>
    </message>
    <message>
        <source>with %1</source>
        <translation>mit %1</translation>
    </message>
    <message>
        <source>There is nothing to fit yet: check parameters in the list.</source>
        <translation>Noch gibt es nichts anzupassen: Parameter in der Liste anhaken.</translation>
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
        <source>Import a measurement and map its columns: measured and simulated traces then appear here.</source>
        <translation>Eine Messung importieren und ihre Spalten zuordnen: Dann erscheinen hier gemessene und simulierte Kurven.</translation>
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
</context>
<context>
    <name>Recovery</name>
    <message>
        <source>Keeping a copy</source>
        <translation>Sicherungskopie</translation>
    </message>
</context>
<context>
    <name>ReportPdf</name>
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
        <source>lag</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>Residual against %1</source>
        <translation>Residuum über %1</translation>
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
        <source>Unexplained structure</source>
        <translation>Unerklärte Struktur</translation>
    </message>
    <message>
        <source>The data cannot show it: it only shifts %1</source>
        <translation>Die Daten können es nicht zeigen: Es verschiebt nur %1</translation>
    </message>
    <message>
        <source>This data cannot tell it from the chosen effect</source>
        <translation>Diese Daten können es vom gewählten Effekt nicht unterscheiden</translation>
    </message>
    <message>
        <source>It does not help on data that was left out of the fit</source>
        <translation>Es hilft nicht auf Daten, die bei der Anpassung ausgelassen waren</translation>
    </message>
    <message>
        <source>It would need a strength of the wrong physical sign</source>
        <translation>Seine Stärke hätte das physikalisch falsche Vorzeichen</translation>
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
        <translation>%1 an %2</translation>
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
        <translation>angepasste Versuche</translation>
    </message>
    <message>
        <source>Over the fitted experiments</source>
        <translation>Über die angepassten Versuche</translation>
    </message>
    <message>
        <source>signal to noise, squared</source>
        <translation>Signal zu Rauschen, quadriert</translation>
    </message>
    <message>
        <source>Squared signal-to-noise ratio of the effect in the residual</source>
        <translation>Quadrat des Signal-Rausch-Verhältnisses des Effekts im Residuum</translation>
    </message>
    <message>
        <source>negative: gains more than it costs</source>
        <translation>negativ: bringt mehr, als er kostet</translation>
    </message>
    <message>
        <source>Negative: the fit gains more than the added parameters cost</source>
        <translation>Negativ: Die Anpassung gewinnt mehr, als die zusätzlichen Parameter kosten</translation>
    </message>
    <message>
        <source>+1: holds on data left out; −1: fails</source>
        <translation>+1: gilt auch dort; −1: nicht</translation>
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
</context>
<context>
    <name>RunBar</name>
    <message>
        <source>fitting</source>
        <translation>anpassen</translation>
    </message>
    <message>
        <source>simulating</source>
        <translation>simulieren</translation>
    </message>
    <message>
        <source>looking at every effect</source>
        <translation>alle Effekte ansehen</translation>
    </message>
    <message>
        <source>trying</source>
        <translation>prüfen</translation>
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
</context>
<context>
    <name>RunController</name>
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
</context>
<context>
    <name>Examples</name>
    <message>
        <source>Heating of an exhaust-gas sensor</source>
        <translation>Aufheizen einer Abgassonde</translation>
    </message>
    <message>
        <source>A planar lambda sensor must be hot before it measures, so it carries an electric heater. What is recorded is the voltage at the heater, its current, and the temperature of the exhaust gas. Since the resistance of the heater rises with its temperature, the current tells how warm the element is.</source>
        <translation>Eine planare Lambdasonde misst erst, wenn sie heiß ist, und trägt deshalb einen elektrischen Heizer. Aufgezeichnet sind die Spannung am Heizer, sein Strom und die Temperatur des Abgases. Da der Widerstand des Heizers mit seiner Temperatur steigt, verrät der Strom, wie warm das Element ist.</translation>
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
</TS>
