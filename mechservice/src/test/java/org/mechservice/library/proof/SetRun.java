package org.mechservice.library.proof;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.LongStream;
import org.mechservice.mechml.diagnosis.MechmlException;

/** Scenes of a set, run, and what came of them. */
final class SetRun {
  /** Kept of a scene that is not right. */
  record Missed(long seed, SceneRun run) {
    @Override
    public String toString() {
      return "seed %d, %s%s, %s: %s, %.2g times the bound%s: %s"
          .formatted(
              seed,
              run.scene().kind(),
              run.scene().detail().isEmpty() ? "" : " " + run.scene().detail(),
              run.scene().method(),
              run.verdict() == Verdict.SILENT ? "wrong in silence" : "wrong and told",
              run.error(),
              run.said().isEmpty() ? "" : " (" + run.said() + ")",
              run.detail());
    }
  }

  /** Counts of one kind of scene. */
  static final class Counts {
    int right;
    int told;
    int silent;
    int dropped;
    double largest;

    void add(Counts other) {
      right += other.right;
      told += other.told;
      silent += other.silent;
      dropped += other.dropped;
      largest = Math.max(largest, other.largest);
    }

    String row(String name) {
      return String.format(
          Locale.ROOT,
          "| %s | %d | %d | %d | %d | %d | %.2g |%n",
          name,
          right + told + silent,
          right,
          told,
          silent,
          dropped,
          largest);
    }
  }

  /**
   * Whether the scenes run in steps so short that nothing can be passed over: a check of the set.
   */
  private static final boolean SHORT_STEPS = Boolean.getBoolean("proof.shortSteps");

  /** Head of a table of counts. */
  static final String HEAD =
      "| kind | scenes | right | told | wrong in silence | dropped | largest error over its bound"
          + " |\n|---|---|---|---|---|---|---|\n";

  private final ProofSet set;
  private final Map<String, Counts> kinds = new LinkedHashMap<>();
  private final List<Missed> missed = new ArrayList<>();

  private SetRun(ProofSet set) {
    this.set = set;
  }

  /** Runs a scene. */
  interface Form {
    /** Returns what came of it. */
    SceneRun run(Scene scene) throws IOException, MechmlException, InterruptedException;
  }

  /** Runs the scenes of some seeds in this process. */
  static SetRun of(ProofSet set, LongStream seeds)
      throws IOException, MechmlException, InterruptedException {
    return of(set, seeds, SceneRun::of);
  }

  /** Runs the scenes of some seeds in another form. */
  static SetRun of(ProofSet set, LongStream seeds, Form form)
      throws IOException, MechmlException, InterruptedException {
    SetRun result = new SetRun(set);
    for (long seed : seeds.toArray()) {
      result.run(seed, form);
    }
    return result;
  }

  private void run(long seed, Form form) throws IOException, MechmlException, InterruptedException {
    Optional<Scene> scene = set.scene(seed);
    if (scene.isEmpty()) {
      kinds.computeIfAbsent("sensitive or refused, dropped", name -> new Counts()).dropped++;
      return;
    }
    if (!scene.get().expected().stream().allMatch(Expected::standsOut)) {
      kinds.computeIfAbsent("below the tolerances, dropped", name -> new Counts()).dropped++;
      return;
    }
    Counts counts = kinds.computeIfAbsent(scene.get().kind(), name -> new Counts());
    SceneRun run = form.run(SHORT_STEPS ? scene.get().inShortSteps() : scene.get());
    switch (run.verdict()) {
      case RIGHT -> counts.right++;
      case TOLD -> counts.told++;
      case SILENT -> counts.silent++;
    }
    if (run.verdict() == Verdict.RIGHT) {
      counts.largest = Math.max(counts.largest, run.error());
    } else {
      missed.add(new Missed(seed, run));
    }
  }

  /** Returns the set. */
  ProofSet set() {
    return set;
  }

  /** Returns the scenes that are not right. */
  List<Missed> missed() {
    return List.copyOf(missed);
  }

  /** Returns the scenes that are wrong without a word. */
  List<Missed> silent() {
    return missed.stream().filter(one -> one.run().verdict() == Verdict.SILENT).toList();
  }

  /** Returns the counts of all scenes. */
  Counts all() {
    Counts all = new Counts();
    kinds.values().forEach(all::add);
    return all;
  }

  /** Returns a table of the kinds. */
  String table() {
    StringBuilder table = new StringBuilder();
    table.append(HEAD);
    kinds.forEach((name, counts) -> table.append(counts.row(name)));
    return table + all().row("all");
  }

  /** Writes the models that are not right, and why, into a folder. */
  void writeMissed(Path folder) throws IOException {
    Files.createDirectories(folder);
    for (Missed one : missed) {
      String name =
          "%s-%d-%s".formatted(set.title().replace(' ', '-'), one.seed(), one.run().verdict());
      Files.writeString(folder.resolve(name + ".xml"), one.run().scene().text());
      Files.writeString(folder.resolve(name + ".txt"), one + "\n");
    }
  }
}
