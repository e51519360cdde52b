// Draws a capsule with three.js. All views share one renderer: browsers allow few of them.
import * as three from "./three.module.min.js";
import {colour_at} from "./colour_map.js";

const kReach = 1.75;        // half of what is seen, in radii of the undeformed capsule
const kTracerRadius = 0.07;
const kMaxTilt = 1.5;       // radian: the view from above is the last

let renderer = null;

function shared_renderer() {
  renderer ??= new three.WebGLRenderer({antialias: true, alpha: true, preserveDrawingBuffer: true});
  return renderer;
}

/// The vertex that is followed: where x is largest, in the plane of shear.
function tracer_of(positions) {
  let best = 0;
  for (let vertex = 0; vertex < positions.length / 3; ++vertex)
    if (positions[3 * vertex] - Math.abs(positions[3 * vertex + 2]) >
        positions[3 * best] - Math.abs(positions[3 * best + 2])) best = vertex;
  return best;
}

/// Arrows of the undisturbed flow u = (k y, 0, 0), above and below the capsule.
function flow_arrows(colour) {
  const arrow = (side) => new three.ArrowHelper(new three.Vector3(side, 0, 0), new three.Vector3(-0.5 * side, 1.55 * side, 0),
                                                1, colour, 0.16, 0.1);
  return [arrow(1), arrow(-1)];
}

export class CapsuleScene {
  /// \param triangles  3 vertices each   \param start  positions at the first time
  constructor(triangles, start) {
    this.tracer = tracer_of(start);
    this.geometry = new three.BufferGeometry();
    this.geometry.setIndex(new three.BufferAttribute(triangles, 1));
    this.geometry.setAttribute("position", new three.BufferAttribute(new Float32Array(start), 3));
    this.geometry.setAttribute("color", new three.BufferAttribute(new Float32Array(start.length), 3));
    const membrane = new three.MeshLambertMaterial({vertexColors: true, side: three.DoubleSide});
    this.marker = new three.Mesh(new three.SphereGeometry(kTracerRadius), new three.MeshLambertMaterial({color: "#D55E00"}));
    this.camera = new three.OrthographicCamera(-kReach, kReach, kReach, -kReach, 0.1, 100);
    this.light = new three.DirectionalLight("white", 2);
    this.scene = new three.Scene();
    this.scene.add(new three.Mesh(this.geometry, membrane), this.marker, this.light, new three.AmbientLight("white", 1.2),
                   ...flow_arrows("#808080"));
    this.look_from_the_front();
  }

  /// Along z, onto the plane of shear.
  look_from_the_front() {
    [this.turn, this.tilt, this.zoom] = [0, 0, 1];
  }

  /// \param turn, tilt  angles in radian that are added
  rotate(turn, tilt) {
    this.turn += turn;
    this.tilt = Math.min(kMaxTilt, Math.max(-kMaxTilt, this.tilt + tilt));
  }

  magnify(factor) {
    this.zoom = Math.min(8, Math.max(0.5, this.zoom * factor));
  }

  /// \param numbers  one at each vertex   \param range  that of the colours
  set_shape(positions, numbers, [low, high]) {
    this.geometry.attributes.position.array.set(positions);
    this.geometry.attributes.position.needsUpdate = true;
    const colour = new three.Color();
    numbers.forEach((number, vertex) => {
      colour.setRGB(...colour_at((number - low) / (high - low || 1)), three.SRGBColorSpace);
      this.geometry.attributes.color.setXYZ(vertex, colour.r, colour.g, colour.b);
    });
    this.geometry.attributes.color.needsUpdate = true;
    this.geometry.computeVertexNormals();
    this.marker.position.fromArray(positions, 3 * this.tracer);
  }

  /// Draws into a canvas of two dimensions.
  draw(canvas) {
    const shared = shared_renderer();
    const distance = 10;
    this.camera.position.set(distance * Math.sin(this.turn) * Math.cos(this.tilt), distance * Math.sin(this.tilt),
                             distance * Math.cos(this.turn) * Math.cos(this.tilt));
    this.camera.lookAt(0, 0, 0);
    this.camera.zoom = this.zoom;
    this.camera.updateProjectionMatrix();
    this.light.position.copy(this.camera.position).add(new three.Vector3(-3, 4, 0));
    shared.setSize(canvas.width, canvas.height, false);
    shared.render(this.scene, this.camera);
    const picture = canvas.getContext("2d");
    picture.clearRect(0, 0, canvas.width, canvas.height);
    picture.drawImage(shared.domElement, 0, 0);
  }
}
