// SPDX-License-Identifier: GPL-3.0-or-later
// Turns the drawings: a surface from its samples in WebGL, in place of the picture that stands
// there without it. Draws only when something has changed.
"use strict";
(() => {
  const vertexShader = `
    attribute vec3 point, normal, colour;
    uniform mat3 turn;
    uniform vec2 scale;
    uniform float lift;
    varying vec3 facing, shade;
    void main() {
      vec3 at = turn * point;
      facing = turn * normal;
      shade = colour;
      gl_Position = vec4(at.xy * scale, -at.z * 0.4 - lift, 1.0);
    }`;
  const fragmentShader = `
    precision mediump float;
    uniform float lit;
    varying vec3 facing, shade;
    void main() {
      // The back of an open surface is seen too: as bright as the front.
      float light = mix(1.0, 0.45 + 0.55 * abs(normalize(facing).z), lit);
      gl_FragColor = vec4(shade * light, 1.0);
    }`;

  function bytes(text) {
    const raw = atob(text);
    const result = new Uint8Array(raw.length);
    for (let i = 0; i < raw.length; ++i) result[i] = raw.charCodeAt(i);
    return result.buffer;
  }
  const fractions = (text, scale) => Float32Array.from(new Int16Array(bytes(text)), (x) => (x / 32767) * scale);
  const colours = (text) => Float32Array.from(new Uint8Array(bytes(text)), (x) => x / 255);

  function program(gl) {
    const result = gl.createProgram();
    for (const [kind, source] of [[gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, fragmentShader]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(result, shader);
    }
    gl.linkProgram(result);
    return gl.getProgramParameter(result, gl.LINK_STATUS) ? result : null;
  }

  function product(a, b) {
    const result = new Float32Array(9);
    for (let i = 0; i < 3; ++i)
      for (let j = 0; j < 3; ++j)
        for (let k = 0; k < 3; ++k) result[3 * j + i] += a[3 * k + i] * b[3 * j + k];
    return result;
  }
  const about = {
    x: (t) => Float32Array.of(1, 0, 0, 0, Math.cos(t), Math.sin(t), 0, -Math.sin(t), Math.cos(t)),
    y: (t) => Float32Array.of(Math.cos(t), 0, -Math.sin(t), 0, 1, 0, Math.sin(t), 0, Math.cos(t)),
  };
  // The view of the printed picture: z upwards, seen from the first octant.
  const start = () => Float32Array.of(-0.6, -0.288, 0.7464, 0.8, -0.216, 0.5598, 0, 0.933, 0.36);

  class View {
    constructor(figure) {
      this.data = JSON.parse(figure.querySelector("script.mesh").textContent);
      this.canvas = document.createElement("canvas");
      this.canvas.tabIndex = 0;
      this.canvas.setAttribute("role", "img");
      this.canvas.setAttribute("aria-label", figure.dataset.title + ", a drawing that turns with the arrow keys");
      this.gl = this.canvas.getContext("webgl", { antialias: true });
      if (!this.gl) return;
      this.program = program(this.gl);
      if (!this.program) return;
      this.ready = true;
      this.turn = start();
      this.zoom = 1;
      this.lines = true;
      this.load();
      this.tools(figure);
      this.listen();
      figure.querySelector(".still").hidden = true;
      const legend = figure.querySelector(".legend");
      if (legend) legend.hidden = false;
      figure.prepend(this.canvas);
      new ResizeObserver(() => this.draw()).observe(this.canvas);
    }

    buffer(target, data) {
      const { gl } = this;
      const result = gl.createBuffer();
      gl.bindBuffer(target, result);
      gl.bufferData(target, data, gl.STATIC_DRAW);
      return result;
    }

    load() {
      const { gl, data } = this;
      gl.useProgram(this.program);
      gl.enable(gl.DEPTH_TEST);
      this.points = this.buffer(gl.ARRAY_BUFFER, fractions(data.points, 1));
      this.normals = this.buffer(gl.ARRAY_BUFFER, fractions(data.normals, 1));
      this.colours = this.buffer(gl.ARRAY_BUFFER, colours(data.colours));
      const corners = new Uint16Array(bytes(data.triangles));
      this.corners = this.buffer(gl.ELEMENT_ARRAY_BUFFER, corners);
      this.cornerCount = corners.length;
      const ends = fractions(data.lines, 1);
      this.ends = this.buffer(gl.ARRAY_BUFFER, ends);
      this.endCount = ends.length / 3;
    }

    attribute(name, buffer) {
      const { gl } = this;
      const place = gl.getAttribLocation(this.program, name);
      if (place < 0) return;
      if (!buffer) {
        gl.disableVertexAttribArray(place);
        return;
      }
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, 3, gl.FLOAT, false, 0, 0);
    }

    draw() {
      if (this.asked) return;
      this.asked = true;
      requestAnimationFrame(() => {
        this.asked = false;
        this.paint();
      });
    }

    paint() {
      const { gl, canvas } = this;
      const density = Math.min(window.devicePixelRatio || 1, 2);
      canvas.width = Math.round(canvas.clientWidth * density);
      canvas.height = Math.round(canvas.clientHeight * density);
      gl.viewport(0, 0, canvas.width, canvas.height);
      gl.clearColor(0, 0, 0, 0);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      const where = (name) => gl.getUniformLocation(this.program, name);
      const size = 0.92 * this.zoom;
      const wide = canvas.width / Math.max(1, canvas.height);
      gl.uniformMatrix3fv(where("turn"), false, this.turn);
      gl.uniform2f(where("scale"), size / Math.max(1, wide), size * Math.min(1, wide));
      gl.uniform1f(where("lift"), 0);
      gl.uniform1f(where("lit"), 1);
      this.attribute("point", this.points);
      this.attribute("normal", this.normals);
      this.attribute("colour", this.colours);
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.corners);
      gl.drawElements(gl.TRIANGLES, this.cornerCount, gl.UNSIGNED_SHORT, 0);
      if (this.lines && this.endCount > 0) this.paintLines(where);
    }

    paintLines(where) {
      const { gl } = this;
      gl.uniform1f(where("lift"), 0.004);
      gl.uniform1f(where("lit"), 0);
      this.attribute("point", this.ends);
      this.attribute("normal", null);
      this.attribute("colour", null);
      const colour = gl.getAttribLocation(this.program, "colour");
      const normal = gl.getAttribLocation(this.program, "normal");
      if (normal >= 0) gl.vertexAttrib3f(normal, 0, 0, 1);
      if (colour >= 0) gl.vertexAttrib3f(colour, 0.1, 0.1, 0.12);
      gl.drawArrays(gl.LINES, 0, this.endCount);
    }

    tools(figure) {
      const tools = document.createElement("div");
      tools.className = "tools";
      const add = (name, action) => {
        const button = document.createElement("button");
        button.type = "button";
        button.textContent = name;
        button.addEventListener("click", () => {
          action(button);
          this.draw();
        });
        tools.append(button);
      };
      add("Reset the view", () => {
        this.turn = start();
        this.zoom = 1;
      });
      if (this.data.lines)
        add("Hide lines", (button) => {
          this.lines = !this.lines;
          button.textContent = this.lines ? "Hide lines" : "Show lines";
        });
      figure.querySelector("figcaption").before(tools);
    }

    rotate(right, down) {
      this.turn = product(about.x(down), product(about.y(right), this.turn));
      this.draw();
    }

    listen() {
      const { canvas } = this;
      let last = null;
      canvas.addEventListener("pointerdown", (event) => {
        last = event;
        canvas.setPointerCapture(event.pointerId);
      });
      canvas.addEventListener("pointermove", (event) => {
        if (!last) return;
        this.rotate((event.clientX - last.clientX) / 150, (event.clientY - last.clientY) / 150);
        last = event;
      });
      for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, () => (last = null));
      // The wheel scrolls the page unless the drawing has been chosen.
      canvas.addEventListener("wheel", (event) => {
        if (document.activeElement !== canvas) return;
        event.preventDefault();
        this.zoom = Math.min(8, Math.max(0.3, this.zoom * Math.exp(-event.deltaY / 600)));
        this.draw();
      }, { passive: false });
      canvas.addEventListener("keydown", (event) => {
        const steps = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] };
        if (event.key in steps) {
          event.preventDefault();
          this.rotate(...steps[event.key]);
        } else if (event.key === "+" || event.key === "-") {
          this.zoom *= event.key === "+" ? 1.1 : 1 / 1.1;
          this.draw();
        }
      });
      canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
      canvas.addEventListener("webglcontextrestored", () => {
        this.program = program(this.gl);
        this.load();
        this.draw();
      });
    }
  }

  // A context is made only when a drawing comes into sight: browsers allow a few at a time.
  const watcher = new IntersectionObserver((entries) => {
    for (const entry of entries)
      if (entry.isIntersecting) {
        watcher.unobserve(entry.target);
        new View(entry.target);
      }
  }, { rootMargin: "200px" });
  for (const figure of document.querySelectorAll("figure.surface")) watcher.observe(figure);
})();
