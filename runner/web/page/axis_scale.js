// Where the values of an axis are drawn, and the numbers beside it.
import {value_words} from "./words.js";

const kLogarithmicSpan = 20;  // last over first value, as `capstan figure`
const kMaxWords = 12;

const is_numeric = (values) => values.every((value) => typeof value === "number");

/// Round numbers between two values, about `count` of them.
export function round_numbers(first, last, count = 6) {
  const rough = (last - first || 1) / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((size) => size >= rough);
  const numbers = [];
  for (let i = Math.ceil(first / step); i * step <= last + 1e-9 * step; ++i)
    numbers.push(Number((i * step).toPrecision(10)));
  return numbers;
}

function round_powers(first, last) {
  const numbers = [];
  for (let power = Math.floor(Math.log10(first)); power <= Math.log10(last); ++power)
    for (const factor of [1, 2, 5]) numbers.push(Number((factor * 10 ** power).toPrecision(3)));
  return numbers.filter((number) => number >= first && number <= last);
}

/// \param from, to  ends of the axis on the screen
/// \param range     [first, last] of the values that are shown, or null for all
/// \return place(index) of a value on the screen; ticks as {place, text}; of numbers also place_of(number) and
///         number_at(place)
export function axis_scale(values, from, to, range = null) {
  const numeric = is_numeric(values);
  const logarithmic = numeric && values[0] > 0 && values.at(-1) > kLogarithmicSpan * values[0];
  const height = (value) => (logarithmic ? Math.log(value) : value);
  const numbers = numeric ? values : values.map((_, index) => index);
  const value_of = (its_height) => (logarithmic ? Math.exp(its_height) : its_height);
  const [low, high] = range ?? [numbers[0], numbers.at(-1)];
  const first = height(low);
  const last = height(high);
  const rim = range ? 0 : last > first ? 0.06 * (last - first) : 1;
  const at = (value) => from + ((height(value) - first + rim) / (last - first + 2 * rim)) * (to - from);
  const number_at = (place) => value_of(first - rim + ((place - from) / (to - from)) * (last - first + 2 * rim));
  const shows = (index) => range === null || (numbers[index] >= low && numbers[index] <= high);
  return {place: (index) => at(numbers[index]), ticks: numeric ? number_ticks() : word_ticks(), shows, numeric,
          place_of: at, number_at};

  function number_ticks() {
    if (numbers.length === 1) return [{place: at(numbers[0]), text: value_words(numbers[0])}];
    const chosen = logarithmic && high > 5 * low ? round_powers(low, high) : round_numbers(low, high);
    return chosen.map((number) => ({place: at(number), text: String(number)}));
  }

  function word_ticks() {
    const stride = Math.ceil(values.length / kMaxWords);
    return values
      .map((value, index) => ({place: at(index), text: value_words(value)}))
      .filter((_, index) => index % stride === 0 && shows(index));
  }
}
