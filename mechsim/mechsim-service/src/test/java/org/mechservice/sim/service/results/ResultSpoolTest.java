package org.mechservice.sim.service.results;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Random;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.sim.service.limits.CurrentLimits;
import org.mechservice.sim.service.limits.HostLimit;
import org.mechservice.sim.service.limits.HostLimits;
import org.mechservice.sim.service.limits.LimitReachedException;
import org.mechservice.sim.service.limits.SpoolQuota;

class ResultSpoolTest {
  private static final int SEED = 20261;
  private static final int COLUMNS = 7;
  private static final long PATIENCE_MILLIS = 60_000;

  /** Enough to be written to the file many times over. */
  private static final int MANY_ROWS = 20_000;

  private static double[] row(long index) {
    double[] values = new double[COLUMNS];
    for (int column = 0; column < COLUMNS; column++) {
      values[column] = index * 10.0 + column;
    }
    return values;
  }

  private static ResultSpool spool() {
    return new ResultSpool(
        COLUMNS,
        RowFile.temporary(),
        new SpoolQuota(new CurrentLimits(HostLimits.DEFAULT), () -> Long.MAX_VALUE).of("ann"));
  }

  private static void assertRows(double[] values, long first, int count) {
    assertThat(values).hasSize(count * COLUMNS);
    for (int i = 0; i < values.length; i++) {
      assertThat(values[i]).isEqualTo((first + i / COLUMNS) * 10.0 + i % COLUMNS);
    }
  }

  @Test
  void runEndsBeforeTheDiskIsFullAndNewOnesAreRefused() throws Exception {
    AtomicLong free = new AtomicLong(3L << 30);
    SpoolQuota quota = new SpoolQuota(new CurrentLimits(HostLimits.DEFAULT), free::get);
    quota.require("ann", 1 << 30, "");
    quota.of("ann").take(1 << 20, 1 << 20);
    assertThatThrownBy(() -> quota.require("ann", 2.5 * (1L << 30), ""))
        .isInstanceOfSatisfying(
            LimitExceeded.class,
            refused -> {
              assertThat(refused.code).isEqualTo("S-174");
              assertThat(refused.limitName).isEqualTo("freeDisk");
            });
    // More than the disk has at all, but not more than a run may have: the disk is the reason.
    for (long most : new long[] {1L << 30, 0}) {
      SpoolQuota small =
          new SpoolQuota(
              new CurrentLimits(HostLimits.DEFAULT.with(HostLimit.FREE_DISK, most)), free::get);
      assertThatThrownBy(() -> small.require("ann", 3.5 * (1L << 30), "make t-step larger"))
          .isInstanceOfSatisfying(
              LimitExceeded.class,
              refused -> {
                assertThat(refused.code).isEqualTo("S-174");
                assertThat(refused.text).doesNotContain("t-step");
              });
    }
    free.set(1L << 30);
    assertThatThrownBy(() -> quota.of("ann").take(1 << 20, 1 << 20))
        .isInstanceOf(LimitReachedException.class)
        .hasMessageContaining("left");
    assertThat(quota.used()).isEqualTo(1 << 20);
  }

  @Test
  void rowsComeBackFromAnyPlaceWhetherInTheFileOrNot() throws IOException {
    Random random = new Random(SEED);
    try (ResultSpool spool = spool()) {
      for (int row = 0; row < MANY_ROWS; row++) {
        spool.append(row(row));
      }
      for (int i = 0; i < 200; i++) {
        int first = random.nextInt(MANY_ROWS);
        int count = 1 + random.nextInt(3000);
        assertRows(spool.read(first, count), first, Math.min(count, MANY_ROWS - first));
      }
      assertThat(spool.read(MANY_ROWS, 5)).isEmpty();
    }
  }

  @Test
  void readersFollowTheWriterAndMissNothing() throws Exception {
    ExecutorService readers = Executors.newFixedThreadPool(3);
    try (ResultSpool spool = spool()) {
      Future<?> slow = readers.submit(() -> follow(spool, 1));
      Future<?> medium = readers.submit(() -> follow(spool, 100));
      Future<?> greedy = readers.submit(() -> follow(spool, 100_000));
      for (int row = 0; row < MANY_ROWS; row++) {
        spool.append(row(row));
      }
      spool.end();
      slow.get();
      medium.get();
      greedy.get();
    } finally {
      readers.shutdown();
    }
  }

  private static Void follow(ResultSpool spool, int most) throws Exception {
    long next = 0;
    while (!spool.endsAt(next)) {
      spool.await(next, PATIENCE_MILLIS);
      double[] values = spool.read(next, most);
      assertRows(values, next, values.length / COLUMNS);
      next += values.length / COLUMNS;
    }
    assertThat(next).isEqualTo(MANY_ROWS);
    return null;
  }

  @Test
  void waitingEndsWithTheLastRow() throws Exception {
    ExecutorService reader = Executors.newSingleThreadExecutor();
    try (ResultSpool spool = spool()) {
      Future<Boolean> ended =
          reader.submit(
              () -> {
                spool.await(0, PATIENCE_MILLIS);
                return spool.endsAt(0);
              });
      spool.end();
      assertThat(ended.get()).isTrue();
    } finally {
      reader.shutdown();
    }
  }

  @Test
  void rowsNobodyReadsTakeNoHeap() throws IOException {
    Runtime machine = Runtime.getRuntime();
    int rows = 4_000_000 / COLUMNS; // 32 MB
    try (ResultSpool spool = spool()) {
      System.gc();
      long before = machine.totalMemory() - machine.freeMemory();
      double[] row = row(1);
      for (int i = 0; i < rows; i++) {
        spool.append(row);
      }
      System.gc();
      long taken = machine.totalMemory() - machine.freeMemory() - before;
      // A quarter of the rows: far above what other threads of the test allocate meanwhile.
      assertThat(taken).isLessThan(8_000_000);
      assertThat(spool.rows()).isEqualTo(rows);
    }
  }

  @Test
  void deletedRowsAreGone() throws IOException {
    ResultSpool spool = spool();
    for (int row = 0; row < MANY_ROWS; row++) {
      spool.append(row(row));
    }
    spool.close();
    assertThatThrownBy(() -> spool.read(0, 1)).isInstanceOf(IOException.class);
    assertThatThrownBy(() -> spool.append(row(0))).isInstanceOf(IOException.class);
    try (Stream<Path> left = Files.list(Path.of(System.getProperty("java.io.tmpdir")))) {
      assertThat(left.map(Path::toString)).noneMatch(name -> name.endsWith(".rows"));
    }
  }
}
