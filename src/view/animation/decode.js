"use strict";
// Numbers as the page carries them: differences as zigzag varints, deflated, in base64.

async function inflated(base64) {
  const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Seven bits a byte, low ones first, the eighth says that more follow; the lowest bit is the sign.
async function unpacked(base64, count) {
  const bytes = await inflated(base64);
  const numbers = new Int32Array(count);
  let at = 0;
  for (let i = 0; i < count; ++i) {
    let value = 0, shift = 0, byte;
    do {
      byte = bytes[at++];
      value |= (byte & 127) << shift;
      shift += 7;
    } while (byte > 127);
    numbers[i] = (value >>> 1) ^ -(value & 1);
  }
  if (at !== bytes.length) throw new Error("the file is damaged");
  return numbers;
}

// Undoes differences in place, from each place where a row of numbers begins.
function sum_once(numbers, first, count) {
  for (let i = first + 1; i < first + count; ++i) numbers[i] += numbers[i - 1];
}

function sum_twice(numbers, first, count) {
  let step = 0;
  for (let i = first + 1; i < first + count; ++i) {
    step += numbers[i];
    numbers[i] = numbers[i - 1] + step;
  }
}
