package org.mechservice.sim.jar;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Deflate as small as it goes: read back by the virtual machine's own inflater. */
class DeflationTest {
  static Stream<Named<byte[]>> contents() throws IOException {
    byte[] noise = new byte[70_000];
    new Random(1).nextBytes(noise);
    byte[] words = new byte[40_000];
    Random random = new Random(2);
    for (int i = 0; i < words.length; i++) {
      words[i] = (byte) (i < 64 || random.nextInt(20) == 0 ? random.nextInt(30) : words[i - 61]);
    }
    return Stream.concat(
        IntStream.of(0, 1, 2, 3, 4, 300, 100_000)
            .mapToObj(length -> Named.of(length + " zeros", new byte[length])),
        Stream.of(
            Named.of("noise", noise),
            Named.of("little noise", Arrays.copyOf(noise, 10)),
            Named.of("noise beyond the window, twice", twice(Arrays.copyOf(noise, 40_000))),
            Named.of("noise within the window, twice", twice(Arrays.copyOf(noise, 20_000))),
            Named.of("words", words),
            Named.of("a class", classFile())));
  }

  private static byte[] twice(byte[] once) {
    byte[] both = Arrays.copyOf(once, 2 * once.length);
    System.arraycopy(once, 0, both, once.length, once.length);
    return both;
  }

  private static byte[] classFile() throws IOException {
    try (InputStream in = Deflation.class.getResourceAsStream("Deflation.class")) {
      return in.readAllBytes();
    }
  }

  @ParameterizedTest
  @MethodSource("contents")
  void whatIsInflatedAgainIsWhatWasDeflated(byte[] content) throws DataFormatException {
    Inflater inflater = new Inflater(true);
    inflater.setInput(Deflation.of(content));
    byte[] read = new byte[content.length + 1];
    int count = inflater.inflate(read);
    assertThat(inflater.finished()).isTrue();
    assertThat(inflater.getRemaining()).isZero();
    inflater.end();
    assertThat(Arrays.copyOf(read, count)).isEqualTo(content);
  }

  @ParameterizedTest
  @MethodSource("contents")
  void itIsNeverLargerThanWhatTheVirtualMachineMakes(byte[] content) {
    assertThat(Deflation.of(content).length)
        .isLessThanOrEqualTo(Packing.QUICK.deflated(content).length);
  }

  @Test
  void theSameBytesAreDeflatedAlike() throws IOException {
    assertThat(Deflation.of(classFile())).isEqualTo(Deflation.of(classFile()));
  }

  /** Fibonacci numbers ask for words as long as there are symbols. */
  @Test
  void noWordIsLongerThanAllowed() {
    int[] counts = new int[25];
    counts[0] = 1;
    counts[1] = 1;
    for (int i = 2; i < counts.length; i++) {
      counts[i] = counts[i - 1] + counts[i - 2];
    }
    PrefixCode code = PrefixCode.of(counts, 15);
    double kraft =
        IntStream.range(0, counts.length).mapToDouble(i -> Math.scalb(1.0, -code.length(i))).sum();
    assertThat(IntStream.range(0, counts.length).map(code::length)).allMatch(n -> n <= 15);
    assertThat(kraft).isEqualTo(1);
  }
}
