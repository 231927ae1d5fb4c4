# Completion of analogon-cli for fish. Commands and options are what the program itself says it takes.
function __analogon_commands
    analogon-cli --help 2>/dev/null | sed -n '/^Subcommands:/,$ s/^  \([a-z]\{1,\}\) \{1,\}\(.*\)/\1\t\2/p'
end
function __analogon_options
    set -l words (commandline -opc)
    test (count $words) -ge 2; or return
    analogon-cli $words[2] --help 2>/dev/null | grep -oE -- '--[a-z][a-z0-9-]*' | sort -u
end
complete -c analogon-cli -n __fish_use_subcommand -f -a '(__analogon_commands)'
complete -c analogon-cli -n 'not __fish_use_subcommand' -a '(__analogon_options)'
