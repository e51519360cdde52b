# fig18a.svg, fig18b.svg and fig18c.svg from result.csv: sh studies/figures.sh PROGRAM fig18
set terminal svg enhanced size 420,320 font 'DejaVu Sans,10'
set encoding utf8
set datafile separator ','
set tics nomirror out
set border 3
set logscale xy
set format y '10^{%T}'
set ylabel 'speed-up'
set key outside right title '{/:Italic Ca}'
array colour[6] = ['#0072B2', '#D55E00', '#009E73', '#CC79A7', '#E69F00', '#56B4E9']
Cas = '0.00625 0.0125 0.025 0.05 0.1 0.2'
set style data linespoints

set output 'fig18/fig18a.svg'
set xlabel '{/:Italic k}, 1/s'
plot for [i = 1:6] 'fig18/result.csv' using (column(1) == word(Cas, i) ? column(2) : NaN):8 pt 7 ps 0.5 lc rgb colour[i] title word(Cas, i)

set output 'fig18/fig18b.svg'
set xlabel '{/:Italic Δt}/{/:Italic δt}'
plot for [i = 1:6] 'fig18/result.csv' using (column(1) == word(Cas, i) ? column(6) : NaN):8 pt 7 ps 0.5 lc rgb colour[i] title word(Cas, i)

set output 'fig18/fig18c.svg'
set xlabel '{/:Italic τ}_e/{/:Italic δt}'
plot for [i = 1:6] 'fig18/result.csv' using (column(1) == word(Cas, i) ? column(7) : NaN):8 pt 7 ps 0.5 lc rgb colour[i] title word(Cas, i)
