import { Player } from './player.js';

const player = new Player(JSON.parse(document.getElementById('data').textContent));
globalThis.mechPlayer = {
  frameTimes: () => player.frameTimes.slice(),
};
