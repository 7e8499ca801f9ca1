package org.mechservice.solver.compact;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.RandomTrees;

class CompactFormTest {
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void mechanismReadFromItsBytesIsTheSame(long seed) {
    Mechanism tree = RandomTrees.tree(seed, 20);

    Mechanism read = CompactForm.read(CompactForm.write(tree));

    assertThat(read).usingRecursiveComparison().isEqualTo(tree);
  }

  @Test
  void damagedBytesAreRefusedByName() {
    byte[] bytes = CompactForm.write(RandomTrees.tree(1, 3));

    for (int length = 0; length < bytes.length; length++) {
      byte[] cut = Arrays.copyOf(bytes, length);
      assertThatIllegalArgumentException()
          .isThrownBy(() -> CompactForm.read(cut))
          .withMessageStartingWith("S-067");
    }
  }

  @Test
  void nothingButDescriptionsComesToLife() {
    byte[] bytes = new RecordWriter().write("x").bytes();
    byte[] foreign = new byte[bytes.length + 1];
    System.arraycopy(bytes, 0, foreign, 1, bytes.length);
    foreign[0] = RecordWriter.RECORD;

    assertThatIllegalArgumentException()
        .isThrownBy(() -> new RecordReader(foreign).read())
        .withMessageStartingWith("S-067");
  }
}
