# For pages that name classes, `Newton` or `State::time`, and functions, `run()`:
# makes them links, which is an error where there is nothing of that name.
s/`([A-Z][A-Za-z]*[a-z](::[A-Za-z_]+)?)(\(\))?`/@ref lumbricus::\1 "\1\3"/g
s/`([a-z_]+)\(\)`/@ref lumbricus::\1 "\1()"/g
