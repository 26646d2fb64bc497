// What the user does with the scene.

class Stage {
  constructor(recording) {
    const element = id => document.getElementById(id);
    [this.canvas, this.slider, this.time, this.menu, this.button, this.bars] =
      ["scene", "slider", "time", "colouring", "play", "bars"].map(element);
    this.recording = recording;
    this.painter = new Painter(this.canvas, recording);
    recording.colourings.forEach((colouring, i) =>
      this.menu.add(new Option(colouring.name, i)));
    this.menu.onchange = () => this.show(this.number);
    this.slider.oninput = () => { this.stop(); this.show(Number(this.slider.value)); };
    this.button.onclick = () => this.playing ? this.stop() : this.play();
    element("home").onclick = () => this.home();
    this.takeDrags();
    new ResizeObserver(() => this.draw()).observe(this.canvas);
    this.number = 0;
    this.show(0);
    this.home();
  }

  home() {
    this.view = this.recording.view.map(row => row.slice());
    [this.zoom, this.shift] = [1, [0, 0]];
    this.draw();
  }

  draw() {
    if (this.view) this.painter.draw(this.view, this.zoom, this.shift);
  }

  show(number) {
    this.number = number;
    this.slider.value = number;
    this.time.value = "t = " + +this.recording.frames[number].time.toPrecision(4);
    const choice = Number(this.menu.value);
    this.painter.load(number, choice);
    if (choice !== this.choice) {
      this.choice = choice;
      this.bars.replaceChildren(...this.recording.colourings[choice].scales
        .filter(scale => scale.high > scale.low).map(scale => this.bar(scale)));
    }
    this.draw();
  }

  bar(scale) {
    const all = document.createElement("div"), strip = document.createElement("i");
    const [low, high, end] = [scale.low, scale.high].map(x => +x.toPrecision(3))
      .concat([document.createElement("span")]);
    const stops = [];
    for (let i = 0; i < 256; i += 15) stops.push("#" + scale.colours.substr(6 * i, 6));
    strip.style.background = `linear-gradient(to right, ${stops.join(",")})`;
    end.textContent = high;
    all.append(strip, end, `${low} – ${scale.label}`);
    return all;
  }

  play() {
    this.playing = true;
    this.button.textContent = "⏸";
    const next = () => {
      if (!this.playing) return;
      this.show((this.number + 1) % this.recording.frames.length);
      this.timer = setTimeout(next, 1000 * this.recording.seconds[this.number]);
    };
    next();
  }

  stop() {
    this.playing = false;
    clearTimeout(this.timer);
    this.button.textContent = "▶";
  }

  takeDrags() {
    const canvas = this.canvas;
    canvas.onpointerdown = event => {
      canvas.setPointerCapture(event.pointerId);
      this.from = [event.clientX, event.clientY];
    };
    canvas.onpointermove = event => {
      if (!event.buttons || !this.from) return;
      const right = event.clientX - this.from[0], up = this.from[1] - event.clientY;
      this.from = [event.clientX, event.clientY];
      if (event.shiftKey || event.buttons !== 1) {
        const unit = 2 * this.painter.halfWindow(this.zoom)[0] / canvas.clientWidth;
        this.shift = [this.shift[0] + unit * right, this.shift[1] + unit * up];
      } else {
        const angle = 2 * Math.PI / Math.max(400, canvas.clientWidth);
        this.view = dragged(this.view, angle * right, angle * up);
      }
      this.draw();
    };
    canvas.oncontextmenu = event => event.preventDefault();
    canvas.addEventListener("wheel", event => {
      event.preventDefault();
      this.zoom = Math.min(100, Math.max(0.2,
        this.zoom * Math.exp(-0.0015 * event.deltaY)));
      this.draw();
    }, {passive: false});
    document.onkeydown = event => {
      if (event.key !== " " || event.target === this.button) return;
      event.preventDefault();
      this.button.click();
    };
  }
}

async function unpacked(text) {
  const bytes = Uint8Array.from(atob(text), c => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream()
    .pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

(async () => {
  try {
    const text = id => document.getElementById(id).textContent;
    const numbers = await unpacked(text("numbers"));
    new Stage(new Recording(JSON.parse(text("words")), numbers));
    document.body.dataset.state = "ready";
  } catch (error) {
    const message = document.getElementById("message");
    message.textContent = error.message;
    message.hidden = false;
    document.body.dataset.state = "failed";
  }
})();
