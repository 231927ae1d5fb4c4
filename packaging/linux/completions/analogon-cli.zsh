#compdef analogon-cli
# Completion of analogon-cli for zsh. Commands and options are what the program itself says it takes.
_analogon_cli() {
    local -a words_of
    if (( CURRENT == 2 )); then
        words_of=(${(f)"$(analogon-cli --help 2>/dev/null |
            sed -n '/^Subcommands:/,$ s/^  \([a-z]\{1,\}\) \{1,\}\(.*\)/\1:\2/p')"})
        _describe 'command' words_of
    elif [[ $PREFIX == -* ]]; then
        words_of=(${(f)"$(analogon-cli $words[2] --help 2>/dev/null | grep -oE -- '--[a-z][a-z0-9-]*' | sort -u)"})
        compadd -a words_of
    else
        _files
    fi
}
_analogon_cli "$@"
