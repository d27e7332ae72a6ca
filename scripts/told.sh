# What experiments say of themselves, for the scripts that draw them.

# The first paragraph of the comment that a file begins with, as one line.
told() { sed -n '/^\/\/ \{0,1\}/!q; s/^\/\/ \{0,1\}//; /^$/q; p' "$1" | tr '\n' ' ' | sed 's/ *$//'; }
