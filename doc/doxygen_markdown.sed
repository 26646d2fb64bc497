# What Doxygen is to see of Markdown files: links that lead out of the pages it
# has become text, and so do those to headings, which are not anchors there; the
# text of others is not set as code, which it would show as backticks.
s/(^|[^!])\[([^]]*)\]\((\.\.\/)*(parameters|examples|CHANGELOG)[^)]*\)/\1\2/g
s/\[([^]]*)\]\(#[^)]*\)/\1/g
s/(\]\([a-z_]*\.md)#[^)]*\)/\1)/g
s/\[`([^]`]*)`\]\(/[\1](/g
