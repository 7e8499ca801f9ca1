package org.mechservice.view.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Base64;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Geometry files become the surfaces they describe; files that are not as they should be do not.
 */
class MeshFolderTest {
  private static final String VRML = "#VRML V2.0 utf8\n";

  @TempDir private Path folder = Path.of("");

  private List<Mesh> read(String name, String text) throws IOException {
    Files.writeString(folder.resolve(name), text);
    return new MeshFolder(folder).read(name);
  }

  private static double[] range(Mesh mesh, int axis) {
    double[] range = {Double.MAX_VALUE, -Double.MAX_VALUE};
    float[] corners = mesh.corners();
    for (int i = axis; i < corners.length; i += 3) {
      range[0] = Math.min(range[0], corners[i]);
      range[1] = Math.max(range[1], corners[i]);
    }
    return range;
  }

  @Test
  void transformsOfVrmlScaleThenTurnThenMove() throws IOException {
    Mesh box =
        read(
                "a.wrl",
                VRML
                    + "Transform { translation 10 0 0 rotation 0 0 1 1.5707963267948966 scale 2 1 1"
                    + " children [ Shape { appearance Appearance { material Material {"
                    + " diffuseColor 1 0 0 transparency .25 } } geometry Box { size 2 4 6 } } ] }")
            .get(0);

    assertThat(range(box, 0)).containsExactly(new double[] {8, 12}, within(1e-6));
    assertThat(range(box, 1)).containsExactly(new double[] {-2, 2}, within(1e-6));
    assertThat(range(box, 2)).containsExactly(new double[] {-3, 3}, within(1e-6));
    assertThat(box.colour()).isEqualTo(0xff0000);
    assertThat(box.opacity()).isEqualTo(0.75);
  }

  @Test
  void facesOfVrmlBecomeTrianglesWithCommasAndCommentsAsSpace() throws IOException {
    Mesh square =
        read(
                "a.wrl",
                VRML
                    + "# a square\nShape { geometry IndexedFaceSet { solid FALSE coord Coordinate {"
                    + " point [ 0 0 0, 1 0 0, 1 1 0, 0 1 0 ] } coordIndex [ 0, 1, 2, 3, -1 ] } }")
            .get(0);

    assertThat(square.triangles()).containsExactly(0, 1, 2, 0, 2, 3);
    assertThat(square.colour()).isEqualTo(Mesh.NO_COLOUR);
  }

  @Test
  void nodesOfVrmlAreUsedAgainByTheirName() throws IOException {
    List<Mesh> both =
        read(
            "a.wrl",
            VRML
                + "DEF ball Shape { geometry Sphere { radius 0.5 } }\n"
                + "Transform { translation 0 0 3 children USE ball }");

    assertThat(range(both.get(0), 2)).containsExactly(new double[] {-0.5, 0.5}, within(1e-6));
    assertThat(range(both.get(1), 2)).containsExactly(new double[] {2.5, 3.5}, within(1e-6));
  }

  @Test
  void cylinderAndConeOfVrmlStandAlongY() throws IOException {
    List<Mesh> solids =
        read(
            "a.wrl",
            VRML
                + "Group { children [ Shape { geometry Cylinder { height 8 } }"
                + " Shape { geometry Cone { height 6 bottomRadius 2 } } ] }");

    assertThat(range(solids.get(0), 1)).containsExactly(new double[] {-4, 4}, within(1e-6));
    assertThat(range(solids.get(1), 1)).containsExactly(new double[] {-3, 3}, within(1e-6));
    assertThat(range(solids.get(1), 0)).containsExactly(new double[] {-2, 2}, within(1e-6));
  }

  @Test
  void stlIsTheSameAsTextAndBinary() throws IOException {
    Mesh text =
        read(
                "a.stl",
                """
                solid a
                facet normal 0 0 1
                outer loop
                vertex 0 0 0
                vertex 1 0 0
                vertex 0 2 0
                endloop
                endfacet
                endsolid a
                """)
            .get(0);
    ByteBuffer bytes = ByteBuffer.allocate(134).order(ByteOrder.LITTLE_ENDIAN);
    bytes.put("solid but binary".getBytes(StandardCharsets.US_ASCII)).putInt(80, 1).position(96);
    for (float number : new float[] {0, 0, 0, 1, 0, 0, 0, 2, 0}) {
      bytes.putFloat(number);
    }
    Files.write(folder.resolve("b.STL"), bytes.array());
    Mesh binary = new MeshFolder(folder).read("b.STL").get(0);

    assertThat(binary.corners()).containsExactly(text.corners());
    assertThat(binary.triangles()).containsExactly(0, 1, 2).containsExactly(text.triangles());
  }

  @Test
  void facesOfObjCountFromOneOrFromTheEnd() throws IOException {
    Mesh mesh =
        read("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1/1/1 2 3//2\nf -4 -2 -1\n").get(0);

    assertThat(mesh.triangles()).containsExactly(0, 1, 2, 0, 2, 3);
  }

  @ValueSource(
      strings = {
        "../a.stl",
        "sub/../../a.stl",
        "..\\a.stl",
        "/etc/passwd",
        "C:\\a.stl",
        "\\\\host\\a.stl",
        "http://example.org/a.stl",
        "file:///etc/passwd"
      })
  @ParameterizedTest
  void nothingOutsideTheModelsFolderIsOpened(String name) {
    assertThatThrownBy(() -> new MeshFolder(folder).read(name))
        .isInstanceOf(MeshException.class)
        .hasMessageStartingWith("graphSrc ")
        .hasMessageMatching("(?s).*(\"\\.\\.\"|absolute path|URL).*");
  }

  @Test
  void linkOutOfTheModelsFolderIsRefused(@TempDir Path elsewhere) throws IOException {
    Path secret = Files.writeString(elsewhere.resolve("a.stl"), "solid a");
    Files.createSymbolicLink(folder.resolve("link.stl"), secret);

    assertThatThrownBy(() -> new MeshFolder(folder).read("link.stl"))
        .isInstanceOf(MeshException.class)
        .hasMessageContaining("link");
  }

  @ValueSource(
      strings = {
        "",
        "#VRML V1.0 ascii\nSeparator { }",
        VRML + "Shape { geometry Box { size 1 1 } }",
        VRML + "Shape { geometry Extrusion { } }",
        VRML + "Shape { geometry IndexedFaceSet { coordIndex [ 0 1 2 -1 ] } }",
        VRML + "Shape { geometry Box { size 1 1 x } }",
        VRML + "Group { children [ ",
        VRML + "Group { children USE missing }",
        VRML + "PROTO A [ ] { Group { } }",
        VRML + "Inline { url \"http://example.org/a.wrl\" }",
        VRML + "Group { }"
      })
  @ParameterizedTest
  void vrmlThatCannotBeShownIsRefusedWithItsName(String text) {
    assertThatThrownBy(() -> read("a.wrl", text))
        .isInstanceOf(MeshException.class)
        .hasMessageStartingWith("graphSrc \"a.wrl\": ");
  }

  @Test
  void deepNestingIsRefused() {
    assertThatThrownBy(() -> read("a.wrl", VRML + "Group { children ".repeat(100_000)))
        .isInstanceOf(MeshException.class)
        .hasMessageContaining("deep");
  }

  @Test
  void uselessRepetitionIsRefused() {
    StringBuilder text = new StringBuilder(VRML + "DEF g0 Group { children [ ] }\n");
    for (int i = 1; i < 40; i++) {
      text.append("DEF g").append(i).append(" Group { children [");
      text.append((" USE g" + (i - 1)).repeat(10)).append(" ] }\n");
    }

    assertThatThrownBy(() -> read("a.wrl", text.toString()))
        .isInstanceOf(MeshException.class)
        .hasMessageContaining("nodes");
  }

  @ValueSource(
      strings = {
        "v 0 0\n",
        "v 0 0 0\nf 1 2 3\n",
        "v 0 0 NaN\n",
        "v 0 0 0\nf 1 1 99999999999999999999"
      })
  @ParameterizedTest
  void objThatIsDamagedIsRefusedWithItsLine(String text) {
    assertThatThrownBy(() -> read("a.obj", text))
        .isInstanceOf(MeshException.class)
        .hasMessageMatching("graphSrc \"a.obj\": line \\d+: .*");
  }

  @Test
  void otherEndingsAreRefused() {
    assertThatThrownBy(() -> read("a.txt", "solid"))
        .isInstanceOf(MeshException.class)
        .hasMessageContaining(".stl");
  }

  /** A square of two triangles in a node that is moved within a node that is turned and scaled. */
  private static final String GLTF =
      """
      {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
       "nodes": [{"rotation": [0, 0, 0.7071067811865476, 0.7071067811865476], "scale": [2, 1, 1],
                  "children": [1]}, {"mesh": 0, "translation": [10, 0, 0]}],
       "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
       "materials": [{"alphaMode": "BLEND",
                      "pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 0.25]}}],
       "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
                     {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}],
       "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48,
                       "byteLength": 12}],
       "buffers": [{%s"byteLength": 60}]}\
      """;

  private static byte[] square() {
    ByteBuffer numbers = ByteBuffer.allocate(60).order(ByteOrder.LITTLE_ENDIAN);
    for (float x : new float[] {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) {
      numbers.putFloat(x);
    }
    for (int corner : new int[] {0, 1, 2, 0, 2, 3}) {
      numbers.putShort((short) corner);
    }
    return numbers.array();
  }

  private static String gltf() {
    String numbers = Base64.getEncoder().encodeToString(square());
    return GLTF.formatted("\"uri\": \"data:application/octet-stream;base64," + numbers + "\", ");
  }

  private static byte[] glb() {
    byte[] json = GLTF.formatted("").getBytes(StandardCharsets.UTF_8);
    int padding = -json.length & 3;
    ByteBuffer file =
        ByteBuffer.allocate(12 + 8 + json.length + padding + 8 + 60).order(ByteOrder.LITTLE_ENDIAN);
    file.putInt(0x46546c67).putInt(2).putInt(file.capacity());
    file.putInt(json.length + padding)
        .putInt(0x4e4f534a)
        .put(json)
        .put(" ".repeat(padding).getBytes(StandardCharsets.US_ASCII));
    file.putInt(60).putInt(0x004e4942).put(square());
    return file.array();
  }

  @Test
  void nodesOfGltfScaleThenTurnThenMove() throws IOException {
    Files.write(folder.resolve("a.glb"), glb());
    for (Mesh square :
        List.of(read("a.gltf", gltf()).get(0), new MeshFolder(folder).read("a.glb").get(0))) {
      assertThat(square.triangles()).containsExactly(0, 1, 2, 0, 2, 3);
      // x from 10 to 11 is doubled and turned to y, y from 0 to 1 to -x
      assertThat(range(square, 0)).containsExactly(new double[] {-1, 0}, within(1e-5));
      assertThat(range(square, 1)).containsExactly(new double[] {20, 22}, within(1e-5));
      assertThat(square.colour()).isEqualTo(0xff0000);
      assertThat(square.opacity()).isEqualTo(0.25);
    }
  }

  @Test
  void gltfThatIsNotAsItShouldBeIsRefused() throws IOException {
    refuse(gltf().replace("\"data:", "\"other.bin?"), "in another file");
    refuse(gltf().replace("\"mesh\": 0", "\"mesh\": 7"), "number 7 of 1 meshes");
    refuse(gltf().replace("\"count\": 4", "\"count\": 400"), "outside its buffer");
    refuse(gltf().replace("\"mesh\": 0", "\"children\": [0]"), "64 deep");
    String twice = "{\"children\": [%d, %<d]}, ";
    StringBuilder nodes = new StringBuilder();
    for (int k = 1; k < 30; k++) {
      nodes.append(twice.formatted(k));
    }
    refuse(
        "{\"scenes\": [{\"nodes\": [0]}], \"nodes\": [" + nodes + "{}]}", "more than 100000 nodes");
    refuse(
        gltf().replace("{\"asset\"", "{\"extensionsRequired\": [\"DRACO\"], \"asset\""), "DRACO");
    refuse("no glTF", "it is no glTF 2.0");
    byte[] whole = glb();
    for (int length = 0; length < whole.length - 1; length += 7) {
      Files.write(folder.resolve("cut.glb"), Arrays.copyOf(whole, length));
      assertThatThrownBy(() -> new MeshFolder(folder).read("cut.glb"))
          .isInstanceOf(MeshException.class);
    }
  }

  /** A small file in which surfaces share their numbers stands for any number of triangles. */
  @Test
  void surfacesThatShareNumbersAreCountedEach() throws IOException {
    int corners = 30_000;
    String numbers = Base64.getEncoder().encodeToString(new byte[12 * corners]);
    for (int surfaces : new int[] {50, 9999}) {
      String text =
          "{\"asset\": {\"version\": \"2.0\"}, \"scenes\": [{\"nodes\": [0]}], \"nodes\":"
              + " [{\"mesh\": 0}], \"meshes\": [{\"primitives\": ["
              + String.join(
                  ",", Collections.nCopies(surfaces, "{\"attributes\": {\"POSITION\": 0}}"))
              + "]}], \"accessors\": [{\"bufferView\": 0, \"componentType\": 5126, \"count\": "
              + corners
              + ", \"type\": \"VEC3\"}], \"bufferViews\": [{\"buffer\": 0}], \"buffers\":"
              + " [{\"uri\": \"data:application/octet-stream;base64,"
              + numbers
              + "\"}]}";
      if (surfaces == 50) {
        assertThat(read("a.gltf", text)).hasSize(50);
      } else {
        refuse(text, "more than 1000000 triangles, counting each surface that shares them");
      }
    }
  }

  private void refuse(String text, String why) {
    assertThatThrownBy(() -> read("a.gltf", text))
        .isInstanceOf(MeshException.class)
        .hasMessageContaining(why);
  }
}
