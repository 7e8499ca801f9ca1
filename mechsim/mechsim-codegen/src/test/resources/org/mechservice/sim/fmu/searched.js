// Runs a module to an end in rows of a step; prints the second state of the last row.
const fs = require('fs');
const [file, end, step] = process.argv.slice(2);
WebAssembly.instantiate(fs.readFileSync(file)).then(({ instance }) => {
  const model = instance.exports;
  model.mech_reset_values();
  const count = model.mech_run(0, Number(end), Number(step), 1e-6);
  const width = 1 + model.mech_count(0) + model.mech_count(2);
  const rows = new Float64Array(model.memory.buffer, model.mech_rows(), count * width);
  console.log(rows[(count - 1) * width + 2]);
});
