package org.mechservice.robot;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.mechservice.mechml.diagnosis.MechmlException;

/**
 * The world of each format is closed: the published schema is in the table, and nothing else
 * passes.
 */
class FormatTableTest {
  /** Each line of a schema is the path of an element and its attributes. */
  @ParameterizedTest
  @EnumSource(RobotFormat.class)
  void tableHasEveryNameOfThePublishedSchema(RobotFormat format) throws IOException {
    FormatTable table = FormatTable.of(format);
    List<String> missing = new ArrayList<>();
    for (String line : schema(format)) {
      int colon = line.indexOf(": ");
      String[] path =
          (colon < 0 ? line.replaceFirst(":$", "") : line.substring(0, colon)).split("/", -1);
      String parent = "";
      boolean readSoFar = true;
      for (int i = 0; i < path.length && readSoFar; i++) {
        // A body of MJCF stands in the world or in a body.
        String around = format == RobotFormat.MJCF && path[i].equals("body") ? "worldbody" : parent;
        if (!table.knows(around, path[i])) {
          missing.add(line);
          readSoFar = false;
        } else if (i == path.length - 1 && colon >= 0) {
          for (String attribute : line.substring(colon + 2).split(" ", -1)) {
            if (!attribute.isEmpty() && !table.knows(around, path[i], attribute)) {
              missing.add(line + " lacks " + attribute);
            }
          }
        }
        readSoFar &= table.looksInto(around, path[i]);
        parent = path[i];
      }
    }
    assertThat(missing).isEmpty();
  }

  private static List<String> schema(RobotFormat format) throws IOException {
    String name = format.title().toLowerCase(Locale.ROOT) + ".schema";
    try (InputStream in =
        Objects.requireNonNull(FormatTableTest.class.getResourceAsStream(name), name)) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8)
          .lines()
          .filter(line -> !line.startsWith("#"))
          .toList();
    }
  }

  /** MuJoCo refuses an unknown name; the readers of URDF and SDF pass over it. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<mujoco><worldbody><body><joint dampnig='1'/><geom size='1'/></body></worldbody></mujoco> | M-007",
        "<mujoco><worldbody><bodi/></worldbody></mujoco> | M-006",
        "<mujoco><default><joint armatur='1'/></default><worldbody/></mujoco> | M-007",
        "<sdf version='1.9'><model name='m'><link name='l'><mass>1</mass></link></model></sdf> | M-085",
        "<sdf version='1.9'><model name='m' still='1'><link name='l'/></model></sdf> | M-085",
        "<robot name='r'><link name='a'><inertail/></link></robot> | M-085",
        "<robot name='r'><link name='a' mass='3'/></robot> | M-085",
      })
  void unknownNameIsRefusedOrLost(String file, String code) {
    List<String> codes = new ArrayList<>();
    try {
      RobotImport.of("r", file.getBytes(StandardCharsets.UTF_8))
          .losses()
          .forEach(loss -> codes.add(loss.code().code()));
    } catch (MechmlException e) {
      e.diagnostics().forEach(said -> codes.add(said.code().code()));
    }
    assertThat(codes).contains(code);
  }
}
