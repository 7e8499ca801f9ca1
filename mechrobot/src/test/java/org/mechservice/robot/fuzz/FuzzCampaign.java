package org.mechservice.robot.fuzz;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.stream.Stream;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.robot.RobotImport;

/** Files of one seed, by kind, and what became of them. */
final class FuzzCampaign {
  private static final Path EXAMPLES = Path.of("..", "examples");

  private final Random random;
  private final Damage damage;
  private final RandomFile drawnFile;
  private final List<byte[]> models;
  private final byte[] robot;
  private final Ordeal examples = new Ordeal();
  private final Ordeal drawn = new Ordeal();
  private final Ordeal robots = new Ordeal();

  FuzzCampaign(long seed) throws IOException {
    random = new Random(seed);
    damage = new Damage(random);
    drawnFile = new RandomFile(Path.of("..", "mechml.dtd"), random);
    models = files();
    robot = Files.readAllBytes(EXAMPLES.resolve("robot/arm.urdf"));
  }

  private static List<byte[]> files() throws IOException {
    try (Stream<Path> found = Files.walk(EXAMPLES)) {
      return found
          .filter(file -> file.toString().endsWith(".xml") && file.getNameCount() > 3)
          .filter(file -> !file.toString().contains("target"))
          .filter(file -> !file.toString().contains("study"))
          .sorted()
          .map(FuzzCampaign::bytes)
          .toList();
    }
  }

  private static byte[] bytes(Path file) {
    try {
      return Files.readAllBytes(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  void damagedExamples(int count) {
    for (int i = 0; i < count; i++) {
      byte[] original = models.get(random.nextInt(models.size()));
      examples.with(damage.to(original), file -> MechmlReader.read("x.xml", file, options()));
    }
  }

  void drawnFiles(int count) {
    for (int i = 0; i < count; i++) {
      byte[] content = drawnFile.next().getBytes(StandardCharsets.UTF_8);
      byte[] file = random.nextInt(3) == 0 ? damage.to(content) : content;
      drawn.with(file, f -> MechmlReader.read("x.xml", f, options()));
    }
  }

  void damagedRobots(int count) {
    for (int i = 0; i < count; i++) {
      robots.with(damage.to(robot), file -> RobotImport.of("x.urdf", file).model());
    }
  }

  /** Now and then something is asked of the file as well. */
  private ReadOptions options() {
    return switch (random.nextInt(20)) {
      case 0 -> ReadOptions.choosing(random.nextBoolean() ? "2" : "rest");
      case 1 -> ReadOptions.setting(Map.of("dampingRatio", random.nextBoolean() ? "0.1" : "1/0"));
      case 2 -> new ReadOptions(Optional.empty(), Map.of(), Set.of("k"));
      default -> ReadOptions.NONE;
    };
  }

  Ordeal examples() {
    return examples;
  }

  Ordeal drawn() {
    return drawn;
  }

  Ordeal robots() {
    return robots;
  }
}
