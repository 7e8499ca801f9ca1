import { Player } from './player.js';

globalThis.mechPlayer = new Player(JSON.parse(document.getElementById('data').textContent)).api();
