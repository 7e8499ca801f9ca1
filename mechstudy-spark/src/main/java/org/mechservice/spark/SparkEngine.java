package org.mechservice.spark;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.apache.spark.api.java.JavaSparkContext;
import org.apache.spark.broadcast.Broadcast;
import org.apache.spark.util.SerializableConfiguration;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.study.run.StudyFiles;
import org.mechservice.study.run.StudyPart;
import org.mechservice.study.run.StudyPlan;
import org.mechservice.study.run.StudyRows;

/** Runs a study on the executors of a Spark context. */
final class SparkEngine {
  private static final double CHUNK_SECONDS = 1;
  private static final int MOST_POINTS = 100_000;

  /** A chunk grows by this factor at most: the first runs of a process are slow. */
  private static final int GROWTH = 16;

  private static final int CHUNKS_PER_PLACE = 4;

  /** While one wave ends, the places that are free work at the next. */
  private static final int WAVES_AT_ONCE = 2;

  private final JavaSparkContext spark;
  private final StudyPlan plan;
  private final StudyFiles files;
  private final org.apache.hadoop.fs.Path table;

  /** Receives the progress of a study. */
  interface Progress {
    /**
     * Is told after each wave.
     *
     * @param done points that are finished
     * @param all points of the study
     */
    void at(int done, int all);
  }

  /** Chunks that are under way or were found. */
  private record Wave(List<Chunk> chunks, Future<List<ChunkRun.Speed>> run) {}

  /**
   * @param file the study's file, on this machine
   * @param table the table to write, .csv or .parquet, in a file system that driver and executors
   *     share
   */
  SparkEngine(JavaSparkContext spark, Path file, StudyPlan plan, String table) throws IOException {
    this.spark = spark;
    this.plan = plan;
    files = StudyFiles.of(file, plan);
    org.apache.hadoop.fs.Path given = new org.apache.hadoop.fs.Path(table);
    this.table = given.getFileSystem(spark.hadoopConfiguration()).makeQualified(given);
  }

  /**
   * Runs the points whose rows are not there yet, and writes the table.
   *
   * @return what the table has
   * @throws IOException if a point cannot be run or a file cannot be written
   * @throws InterruptedException if the thread is interrupted
   */
  StudyRows run(Progress progress) throws IOException, InterruptedException {
    StudyRows rows = new StudyRows(plan, StudyPart.WHOLE);
    String folder = table + ".unfinished";
    try (RowFiles store = new RowFiles(folder, spark.hadoopConfiguration(), files.identity())) {
      List<Chunk> used = compute(rows, store, folder, progress);
      write(store, rows, used);
      store.delete();
    }
    return rows;
  }

  /** Returns the chunks that make up the table. */
  private List<Chunk> compute(StudyRows rows, RowFiles store, String folder, Progress progress)
      throws IOException, InterruptedException {
    List<Chunk> there = store.found();
    Deque<Chunk> found = new ArrayDeque<>(there);
    Broadcast<StudyFiles> study = spark.broadcast(files);
    Broadcast<SerializableConfiguration> hadoop =
        spark.broadcast(new SerializableConfiguration(spark.hadoopConfiguration()));
    ChunkRun task = new ChunkRun(study, hadoop, folder);
    ExecutorService submitters = Executors.newFixedThreadPool(WAVES_AT_ONCE);
    List<Chunk> used = new ArrayList<>();
    try {
      Deque<Wave> open = new ArrayDeque<>();
      int next = rows.from();
      int size = 1;
      while (!rows.isComplete()) {
        while (next < rows.to() && open.size() < WAVES_AT_ONCE) {
          List<Chunk> chunks = chunks(next, rows.to(), size, found);
          List<Chunk> missing = chunks.stream().filter(chunk -> !there.contains(chunk)).toList();
          open.addLast(new Wave(chunks, submitters.submit(() -> run(missing, task))));
          next = chunks.get(chunks.size() - 1).end();
        }
        Wave done = open.removeFirst();
        List<ChunkRun.Speed> speeds = done.run.get();
        for (Chunk chunk : done.chunks) {
          if (!rows.isComplete()) {
            used.add(chunk);
            take(store, chunk, rows);
          }
        }
        size = size(size, speeds);
        progress.at(rows.taken(), rows.to() - rows.from());
      }
    } catch (ExecutionException e) {
      throw new IOException(e.getMessage(), e);
    } finally {
      submitters.shutdownNow();
      spark.cancelAllJobs();
    }
    return used;
  }

  private List<ChunkRun.Speed> run(List<Chunk> chunks, ChunkRun task) {
    return chunks.isEmpty()
        ? List.of()
        : spark.parallelize(chunks, chunks.size()).map(task).collect();
  }

  private static void take(RowFiles store, Chunk chunk, StudyRows rows) throws IOException {
    int before = rows.taken();
    store.read(
        chunk,
        line -> {
          rows.take(line);
          return !rows.isEndedByRule();
        });
    if (rows.taken() - before != chunk.size() && !rows.isEndedByRule()) {
      throw new IOException(
          MessageCode.FILE_UNUSABLE
              + " the file of the points from "
              + chunk.first()
              + " to "
              + (chunk.end() - 1)
              + " is cut off; delete it, and run the study again");
    }
  }

  /** Returns chunks for all places; takes those that are found. */
  private List<Chunk> chunks(int from, int to, int size, Deque<Chunk> found) {
    List<Chunk> chunks = new ArrayList<>();
    int wanted = CHUNKS_PER_PLACE * Math.max(1, spark.defaultParallelism());
    int next = from;
    while (next < to && chunks.size() < wanted) {
      while (!found.isEmpty() && found.getFirst().first() < next) {
        found.removeFirst(); // another chunk has its points
      }
      Chunk known = found.peekFirst();
      int end = Math.min(to, known == null ? to : known.first());
      Chunk chunk =
          known != null && known.first() == next
              ? known
              : new Chunk(next, (int) Math.min(end, (long) next + size));
      chunks.add(chunk);
      next = chunk.end();
    }
    return chunks;
  }

  private static int size(int before, List<ChunkRun.Speed> speeds) {
    double seconds = speeds.stream().mapToDouble(ChunkRun.Speed::seconds).sum();
    int points = speeds.stream().mapToInt(ChunkRun.Speed::points).sum();
    if (points == 0) {
      return before;
    }
    double most = Math.min(MOST_POINTS, (double) GROWTH * before);
    return (int) Math.max(1, Math.min(most, CHUNK_SECONDS * points / Math.max(seconds, 1e-9)));
  }

  private void write(RowFiles store, StudyRows rows, List<Chunk> used) throws IOException {
    store.write(
        table,
        raw -> {
          BufferedOutputStream out = new BufferedOutputStream(raw, 1 << 16);
          StudyRows.Lines lines = reader -> each(store, rows, used, reader);
          if (table.getName().toLowerCase(Locale.ROOT).endsWith(".parquet")) {
            rows.writeParquet(out, lines);
          } else {
            out.write(rows.header().getBytes(StandardCharsets.UTF_8));
            lines.each(
                line -> {
                  out.write(line.getBytes(StandardCharsets.UTF_8));
                  out.write('\n');
                });
          }
          out.flush();
        });
    String name = table.getName();
    String beside = name.substring(0, name.lastIndexOf('.')) + ".study.json";
    store.write(
        new org.apache.hadoop.fs.Path(table.getParent(), beside),
        out -> out.write(rows.provenance().getBytes(StandardCharsets.UTF_8)));
  }

  private static void each(
      RowFiles store, StudyRows rows, List<Chunk> used, StudyRows.LineReader reader)
      throws IOException {
    int[] left = {rows.taken()};
    for (Chunk chunk : used) {
      store.read(
          chunk,
          line -> {
            reader.take(line);
            return --left[0] > 0;
          });
    }
  }
}
