package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Base64;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Files from somewhere else, given to {@code ./mech}: one message by name, no trace of a stack. */
class HostileFilesIT {
  @TempDir private Path folder;

  private Terminal.Ended refused(String... words) {
    Terminal.Ended ended = new Terminal(folder).mech(words);
    assertThat(ended.exitStatus()).as(ended.toString()).isNotZero();
    assertThat(ended.stderr()).doesNotContain("\tat ", "Exception in thread");
    return ended;
  }

  /** A text of 2 GB in a file of 144 bytes, itself or as a cell of a cell. */
  @ValueSource(strings = {"plot r.mat -o p.svg", "compare r.mat r.mat", "plot r.mat -o p.html"})
  @ParameterizedTest
  void resultThatClaimsMoreThanItHolds(String command) throws IOException {
    ByteBuffer file = ByteBuffer.allocate(144).order(ByteOrder.LITTLE_ENDIAN);
    byte[] head = new byte[124];
    Arrays.fill(head, (byte) ' ');
    file.put(head).putShort((short) 0x0100).put("IM".getBytes(StandardCharsets.US_ASCII));
    file.putInt(14).putInt(Integer.MAX_VALUE).putLong(0);
    Files.write(folder.resolve("r.mat"), file.array());
    assertThat(refused(command.split(" ", -1)).stderr())
        .startsWith("S-177 r.mat cannot be read")
        .contains("claims 2147483647 bytes where there are 8");
  }

  @Test
  void partThatIsALinkOutOfTheFolder() throws IOException {
    Path model = Files.createDirectory(folder.resolve("model"));
    Files.writeString(folder.resolve("secret.part"), "<subsystem/>");
    Files.createSymbolicLink(model.resolve("a.part"), folder.resolve("secret.part"));
    Files.writeString(
        model.resolve("m.xml"),
        Files.readString(WorkingTree.PENDULUM)
            .replace("<Bodies>", "<include file=\"a.part\" prefix=\"x_\"/><Bodies>"));
    for (String command : new String[] {"check model/m.xml", "show model/m.xml -o p.svg"}) {
      assertThat(refused(command.split(" ", -1)).stderr())
          .contains("S-042")
          .contains("a link out of the model's folder");
    }
  }

  /** What else a model reads from files: tables and meshes. */
  @Test
  void tableAndMeshThatAreLinksOutOfTheFolder() throws IOException {
    Path model = Files.createDirectory(folder.resolve("model"));
    Files.writeString(folder.resolve("secret.csv"), "t,x\n0,0\n1,1\n");
    Files.writeString(folder.resolve("secret.stl"), "solid s\nendsolid s\n");
    for (String end : new String[] {"csv", "stl"}) {
      Files.createSymbolicLink(model.resolve("a." + end), folder.resolve("secret." + end));
    }
    String pendulum = Files.readString(WorkingTree.PENDULUM);
    String table = "<Tables><table name=\"w\" file=\"a.csv\"/></Tables>";
    Files.writeString(
        model.resolve("t.xml"), pendulum.replaceFirst("<Bodies>", table + "<Bodies>"));
    assertThat(refused("check", "model/t.xml").stderr())
        .contains("S-042")
        .contains("a link out of the model's folder");
    Files.writeString(
        model.resolve("g.xml"),
        pendulum.replaceFirst("<body name=\"bar1\"", "<body name=\"bar1\" graphSrc=\"a.stl\""));
    assertThat(simplyDrawn("model/g.xml")).contains("a.stl", "a link that leads out of the model");
  }

  /** Half a megabyte that stands for a thousand million corners. */
  @Test
  void meshThatClaimsMoreThanItHolds() throws IOException {
    int corners = 100_000;
    byte[] data = new byte[12 * corners];
    String primitive = "{\"attributes\":{\"POSITION\":0}}";
    String text =
        "{'asset':{'version':'2.0'},'scenes':[{'nodes':[0]}],'scene':0,'nodes':[{'mesh':0}],"
            + "'meshes':[{'primitives':[%s]}],'accessors':[{'bufferView':0,'componentType':5126,"
            + "'count':%d,'type':'VEC3'}],'bufferViews':[{'buffer':0,'byteLength':%d}],"
            + "'buffers':[{'byteLength':%d,'uri':'data:application/octet-stream;base64,%s'}]}";
    Files.writeString(
        folder.resolve("shared.gltf"),
        text.replace('\'', '"')
            .formatted(
                (primitive + ",").repeat(9998) + primitive,
                corners,
                data.length,
                data.length,
                Base64.getEncoder().encodeToString(data)));
    Files.writeString(
        folder.resolve("m.xml"),
        Files.readString(WorkingTree.PENDULUM)
            .replaceFirst("<body name=\"bar1\"", "<body name=\"bar1\" graphSrc=\"shared.gltf\""));
    assertThat(simplyDrawn("m.xml")).contains("shared.gltf", "more than 1000000 triangles");
  }

  /** Returns what is said of a mesh that is not used; the picture is made without it. */
  private String simplyDrawn(String model) {
    String said = "";
    for (String target : new String[] {"p.html", "p.glb"}) {
      Terminal.Ended ended = new Terminal(folder).mech("view", model, "-o", target).orFail();
      said = ended.stdout() + ended.stderr();
      assertThat(said).contains("drawn as a simple shape").doesNotContain("\tat ", "Exception");
    }
    return said;
  }

  /** Whatever needs too much memory says how to give it more. */
  @Test
  void memoryThatDoesNotSuffice() throws IOException {
    String row = "0,".repeat(20_000) + "0\n";
    String names =
        IntStream.range(0, 20_001).mapToObj(i -> "c" + i + ",").collect(Collectors.joining());
    Files.writeString(
        folder.resolve("r.csv"),
        "t," + names.substring(0, names.length() - 1).replace("c0,", "") + "\n" + row.repeat(700));
    Terminal.Ended ended =
        new Terminal(folder)
            .shell("JDK_JAVA_OPTIONS=-Xmx100m " + WorkingTree.MECH + " compare r.csv r.csv 2>&1");
    assertThat(ended.exitStatus()).as(ended.toString()).isEqualTo(1);
    assertThat(ended.stdout()).contains("S-110", "-Xmx8g").doesNotContain("\tat ");
  }
}
