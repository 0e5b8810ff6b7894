// node predict.js MODEL.onnx WIDTH FACTOR PICTURE.ppm …
// What a stranger's program does with the network, from the description of model.onnx alone, with ONNX Runtime: prints the eight
// outputs for each picture. Pictures are of one size. FACTOR 0: reduce to WIDTH.
const fs = require('fs'), ort = require('onnxruntime-web');

function readPpm(file) {
  const bytes = fs.readFileSync(file);
  const header = /^P6\s+(\d+)\s+(\d+)\s+255\s/.exec(bytes.toString('latin1', 0, 64));
  return {width: +header[1], height: +header[2], rgb: bytes.subarray(header[0].length)};
}

function gray({width, height, rgb}) {
  return Array.from({length: width * height}, (_, i) =>
      Math.round(0.2126 * rgb[3 * i] + 0.7152 * rgb[3 * i + 1] + 0.0722 * rgb[3 * i + 2]));
}

// How much of original pixel j lies under reduced pixel i, along one axis.
function share(i, j, from, to) {
  const scale = from / to;
  return Math.max(0, Math.min((i + 1) * scale, j + 1) - Math.max(i * scale, j)) / scale;
}

function reduce(pixels, width, height, toWidth, toHeight) {
  const result = [];
  for (let y = 0; y < toHeight; ++y)
    for (let x = 0; x < toWidth; ++x) {
      let sum = 0;
      for (let v = Math.floor(y * height / toHeight); v < height && v < (y + 1) * height / toHeight; ++v)
        for (let u = Math.floor(x * width / toWidth); u < width && u < (x + 1) * width / toWidth; ++u)
          sum += share(x, u, width, toWidth) * share(y, v, height, toHeight) * pixels[v * width + u];
      result.push(Math.round(sum));
    }
  return result;
}

(async () => {
  const [model, width, factor, ...pictures] = process.argv.slice(2);
  ort.env.wasm.numThreads = 1;
  ort.env.logLevel = 'error';
  const session = await ort.InferenceSession.create(model);
  const images = pictures.map(readPpm), {width: w, height: h} = images[0];
  const scale = +factor ? 1 / factor : Math.min(1, width / w);
  const toWidth = Math.max(1, Math.round(w * scale)), toHeight = Math.max(1, Math.round(h * scale));
  const pixels = images.flatMap(image => reduce(gray(image), w, h, toWidth, toHeight));
  const outputs = await session.run({
    image: new ort.Tensor('float32', Float32Array.from(pixels), [images.length, 1, toHeight, toWidth]),
    size: new ort.Tensor('float32', Float32Array.from(images.flatMap(() => [h, w])), [images.length, 2])
  });
  console.log(JSON.stringify(images.map((_, i) => session.outputNames.map(name => outputs[name].data[i]))));
})().catch(error => { console.error(error); process.exit(1); });
