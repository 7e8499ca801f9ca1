package org.mechservice.sim.emit;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.GeneratedModel;
import org.mechservice.sim.model.LoopAgreement;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.sim.model.Omission;
import org.mechservice.sim.model.RandomMechmlForces;
import org.mechservice.sim.model.RandomMechmlTrees;
import org.mechservice.sim.model.Scenes;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.mechanism.Mechanism;

/** What a person who knows Java would not write is not in the source of a model. */
@Tag("slow")
class ReadableSourceTest {
  private static final int BODIES = 4;

  /** A sign before a sign: {@code a + -2 * b}, {@code a - -2 * b}, {@code -(-2 * b)}. */
  private static final Pattern SIGNS = Pattern.compile("[-+]\\s+-\\d|-\\(-");

  private static final Pattern LOCAL = Pattern.compile("double (\\w+) = ([^;]*);");
  private static final Pattern METHOD = Pattern.compile("\n {2}(?=@Override|public|private)");

  private static final Pattern WORD = Pattern.compile("\\w+");

  /** Generated once, for every law to be looked up in. */
  private static final List<String> SOURCES = generate();

  /** Loops, driven joints, forces, and relations that change in time. */
  private static List<String> generate() {
    Stream<Mechanism> loops = IntStream.rangeClosed(1, 12).mapToObj(LoopAgreement::scene);
    Stream<Mechanism> trees =
        LongStream.rangeClosed(1, 12)
            .mapToObj(seed -> RandomMechmlForces.on(RandomMechmlTrees.driven(seed, BODIES), seed));
    return Stream.concat(
            loops.map(scene -> source(scene, "RR-JF", "penalty")),
            trees.map(scene -> source(scene, "RR-JF", "auto")))
        .toList();
  }

  static List<String> sources() {
    return SOURCES;
  }

  private static String source(Mechanism mechanism, String formulation, String closure) {
    BuildOptions options = LoopAgreement.options(formulation, closure, false);
    return ModelFactory.generate(Scenes.model(mechanism), options).source();
  }

  private static List<String> found(Pattern pattern, String source) {
    return pattern.matcher(withoutComments(source)).results().map(MatchResult::group).toList();
  }

  private static String withoutComments(String source) {
    return source.replaceAll("(?s)/\\*.*?\\*/|//[^\n]*", "");
  }

  @ParameterizedTest
  @MethodSource("sources")
  void noSignStandsBeforeASign(String source) {
    assertThat(found(SIGNS, source)).isEmpty();
  }

  @ParameterizedTest
  @MethodSource("sources")
  void noVariableIsAnotherNameOfAVariable(String source) {
    List<String> aliases = new ArrayList<>();
    LOCAL
        .matcher(withoutComments(source))
        .results()
        .filter(local -> local.group(2).matches("[A-Za-z]\\w*"))
        .forEach(local -> aliases.add(local.group()));
    assertThat(aliases).isEmpty();
  }

  @ParameterizedTest
  @MethodSource("sources")
  void everyVariableIsRead(String source) {
    List<String> unread = new ArrayList<>();
    for (String method : METHOD.split(withoutComments(source), -1)) {
      Map<String, Long> occurrences =
          WORD.matcher(method)
              .results()
              .collect(Collectors.groupingBy(MatchResult::group, Collectors.counting()));
      LOCAL
          .matcher(method)
          .results()
          .map(local -> local.group(1))
          .filter(name -> occurrences.getOrDefault(name, 0L) < 2)
          .forEach(unread::add);
    }
    assertThat(unread).isEmpty();
  }

  /** With what a cut joint does said of the tree alone: it may slide where no joint of it does. */
  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 4, 5, 6, 7, 8})
  void aMechanismWithLoopsSaysWhatItLeavesOut(int seed) {
    Mechanism mechanism = LoopAgreement.scene(seed);
    GeneratedModel generated =
        ModelFactory.generate(
            Scenes.model(mechanism), LoopAgreement.options("DSR", "projection", false));
    String comments = generated.source().replaceAll("\\s*\n\\s*\\*\\s*", " ");
    assertThat(comments).contains("Left out: ").doesNotContain("loop closures and constraints (");
    assertThat(generated.leftOut())
        .allSatisfy(
            omission -> assertThat(comments).contains(omission.what(), "(" + omission.why() + ")"))
        .extracting(Omission::why)
        .doesNotContain("no joint slides", "no joint turns", "no joint is spherical or free");
  }

  @Test
  void parametersKeepTheirNames() throws Exception {
    byte[] file;
    try (var in = Objects.requireNonNull(Scenes.class.getResourceAsStream("tuned.xml"))) {
      file = in.readAllBytes();
    }
    String text =
        new String(file, StandardCharsets.UTF_8).replace("-k*slide.q", "-k*slide.q - k*slide.v");
    MechmlModel model = MechmlReader.read("tuned.xml", text.getBytes(StandardCharsets.UTF_8));
    RunSettings settings = new RunSettings(0, 1, 0.1, "DE", 1e-6, 1e-8);
    BuildOptions options = new BuildOptions("auto", Set.of(), settings);
    assertThat(ModelFactory.generate(model, options).source()).contains("double p_k = p[");
  }
}
