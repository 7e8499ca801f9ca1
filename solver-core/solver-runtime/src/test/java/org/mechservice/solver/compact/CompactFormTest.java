package org.mechservice.solver.compact;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.FormulaEvaluation;
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

  /** A note on thousands of redundant equations is longer than 65535 bytes. */
  @Test
  void longTextsAreKeptWhole() {
    String text = "\u03a6 ".repeat(50_000);
    RecordReader reader = new RecordReader(new RecordWriter().write(text).write(text).bytes());
    assertThat(reader.read()).isEqualTo(text);
    assertThat(reader.read()).isEqualTo(text);
  }

  /** Twice itself sixty times: a tree of 2^60 sums, sixty objects. */
  @Test
  void sharedPartsOfFormulasAreWrittenOnce() {
    Expression doubled = new Expression.Time();
    for (int i = 0; i < 60; i++) {
      doubled = new Expression.Sum(doubled, doubled);
    }
    byte[] bytes = new RecordWriter().write(doubled).write(doubled).bytes();
    RecordReader reader = new RecordReader(bytes);
    Expression first = (Expression) reader.read();
    assertThat(reader.read()).isSameAs(first);
    assertThat(bytes).hasSizeLessThan(1000);
    FormulaEvaluation evaluation = new FormulaEvaluation(List.of(first));
    evaluation.setLeaf(0, 1);
    evaluation.values();
    assertThat(evaluation.value(0)).isEqualTo(0x1p60);
  }
}
