# fish completion of cls. Asks the program that the line names: cls completion fish | source
function __cls_complete
    set -l words (commandline -opc)
    set -l program $words[1]
    set -e words[1]
    set -l word (commandline -ct)
    for line in (command $program complete -- $words $word 2>/dev/null)
        set -l parts (string split -m 1 \t -- $line)
        switch $line
            case ':folders*'
                __cls_paths __fish_complete_directories $parts[2] $word
            case ':files*'
                __cls_paths __fish_complete_path $parts[2] $word
            case '*'
                echo $line
        end
    end
end

function __cls_paths -a complete_path prefix word
    set -l path (string sub -s (math (string length -- "$prefix") + 1) -- "$word")
    for line in ($complete_path "$path")
        echo $prefix$line
    end
end

complete -c cls -f -a '(__cls_complete)'
