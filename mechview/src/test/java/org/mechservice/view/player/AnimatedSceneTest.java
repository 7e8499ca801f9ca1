package org.mechservice.view.player;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.view.mesh.MeshFolder;
import org.mechservice.view.scene.SceneDescription;

/** The animated scene is a glTF 2.0 binary whose numbers are the run's. */
class AnimatedSceneTest {
  private final ByteBuffer file = file();
  private final JsonObject gltf = gltf();

  private static ByteBuffer file() {
    SceneDescription scene = Pendulums.scene("bar", "");
    Stage stage = new Stage(scene, new MeshFolder(Path.of(".")));
    byte[] bytes = AnimatedScene.write(scene, stage, Pendulums.recording("bar", 21, 0.1));
    return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
  }

  private JsonObject gltf() {
    byte[] json = new byte[file.getInt(12)];
    file.get(20, json);
    String text = new String(json, StandardCharsets.UTF_8);
    return JsonParser.parseString(text).getAsJsonObject();
  }

  private JsonObject element(String list, int index) {
    return gltf.getAsJsonArray(list).get(index).getAsJsonObject();
  }

  private float number(int accessor, int index) {
    JsonObject view =
        element("bufferViews", element("accessors", accessor).get("bufferView").getAsInt());
    return file.getFloat(20 + file.getInt(12) + 8 + view.get("byteOffset").getAsInt() + 4 * index);
  }

  @Test
  void lengthsInTheHeadersAreThoseOfTheFile() {
    int json = file.getInt(12);

    assertThat(file.getInt(0)).isEqualTo(0x46546c67);
    assertThat(file.getInt(4)).isEqualTo(2);
    assertThat(file.getInt(8)).isEqualTo(file.capacity());
    assertThat(json % 4).isZero();
    assertThat(20 + json + 8 + file.getInt(20 + json)).isEqualTo(file.capacity());
    assertThat(element("buffers", 0).get("byteLength").getAsInt())
        .isEqualTo(file.getInt(20 + json));
  }

  @Test
  void bodyTurnsAsInTheRunAlongTheShorterWay() {
    JsonObject animation = element("animations", 0);
    JsonArray channels = animation.getAsJsonArray("channels");
    int bar = 0;
    while (!element("nodes", bar).get("name").getAsString().equals("bar")
        || !element("nodes", bar).has("children")) {
      bar++;
    }
    int output = -1;
    for (JsonElement channel : channels) {
      JsonObject target = channel.getAsJsonObject().getAsJsonObject("target");
      if (target.get("node").getAsInt() == bar
          && target.get("path").getAsString().equals("rotation")) {
        int sampler = channel.getAsJsonObject().get("sampler").getAsInt();
        output =
            animation
                .getAsJsonArray("samplers")
                .get(sampler)
                .getAsJsonObject()
                .get("output")
                .getAsInt();
      }
    }
    for (int frame = 0; frame < 21; frame++) {
      double half = Math.PI * frame * 0.1 / 2;
      assertThat((double) number(output, 4 * frame + 1)).isCloseTo(Math.sin(half), within(1e-6));
      assertThat((double) number(output, 4 * frame + 3)).isCloseTo(Math.cos(half), within(1e-6));
    }
  }

  @Test
  void springIsANodeOfItsOwnAndUnitsAreTold() {
    int spring = 0;
    while (!element("nodes", spring).get("name").getAsString().equals("s")) {
      spring++;
    }
    assertThat(element("nodes", spring).has("mesh")).isTrue();
    assertThat(gltf.getAsJsonArray("materials")).isNotEmpty();
    assertThat(element("scenes", 0).getAsJsonObject("extras").get("lengthUnit").getAsString())
        .isEqualTo("m");
  }

  /**
   * The program of the Khronos Group that checks glTF files finds no error, and nothing to warn of.
   * It is the package gltf-validator of npm, in the folder that MECH_GLTF_VALIDATOR names.
   */
  @Test
  void validatorOfTheKhronosGroupFindsNothing(@TempDir Path directory) throws Exception {
    String validator = System.getenv("MECH_GLTF_VALIDATOR");
    assumeTrue(validator != null, "MECH_GLTF_VALIDATOR names no gltf-validator");
    byte[] bytes = new byte[file.capacity()];
    file.get(0, bytes);
    Path scene = Files.write(directory.resolve("scene.glb"), bytes);
    String script =
        "require(process.argv[1])"
            + ".validateBytes(new Uint8Array(require('fs').readFileSync(process.argv[2])))"
            + ".then(report => console.log(JSON.stringify(report.issues)))";

    Process node =
        new ProcessBuilder("node", "-e", script, validator, scene.toString())
            .redirectErrorStream(true)
            .start();
    String printed = new String(node.getInputStream().readAllBytes(), StandardCharsets.UTF_8);

    assertThat(node.waitFor()).as(printed).isZero();
    JsonObject issues = JsonParser.parseString(printed).getAsJsonObject();
    assertThat(issues.get("numErrors").getAsInt()).as(printed).isZero();
    assertThat(issues.get("numWarnings").getAsInt()).as(printed).isZero();
  }
}
