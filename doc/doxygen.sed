# What Doxygen is to see of C++ files. Equations in comments stand two columns
# further right than the text; with six they are shown as they are. Types of
# deal.II lose their namespace, as in `using dealii::Tensor`.
s/^( *\*)   ( *[^ ])/\1       \2/
/^ *namespace [A-Za-z]+ =/!s/dealii:://g
