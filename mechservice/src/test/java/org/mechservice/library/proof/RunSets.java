package org.mechservice.library.proof;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.LongStream;

/**
 * Runs sets by hand: {@code RunSets TITLE FROM TO [FOLDER]} prints the table and every scene that
 * is not right, and writes its model into the folder.
 */
final class RunSets {
  private RunSets() {}

  static final List<ProofSet> SETS =
      List.of(new Hits(), new Ways(), new Roads(), new OneSided(), new Pulses());

  public static void main(String[] arguments) throws Exception {
    for (ProofSet set : SETS) {
      if (!set.title().equals(arguments[0]) && !arguments[0].equals("all")) {
        continue;
      }
      long start = System.nanoTime();
      SetRun run =
          SetRun.of(
              set,
              LongStream.rangeClosed(Long.parseLong(arguments[1]), Long.parseLong(arguments[2])));
      System.out.println(set.title() + "\n" + run.table());
      run.missed().forEach(System.out::println);
      System.out.printf("%.1f s%n", (System.nanoTime() - start) / 1e9);
      if (arguments.length > 3 && !arguments[3].isEmpty()) {
        run.writeMissed(Path.of(arguments[3]));
      }
    }
  }
}
