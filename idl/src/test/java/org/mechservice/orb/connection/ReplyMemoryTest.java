package org.mechservice.orb.connection;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.Socket;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class ReplyMemoryTest {
  private static final int SIZE = 1 << 20;

  private final ReplyMemory room = new ReplyMemory(SIZE);

  @AfterEach
  void noThreadIsLeft() {
    room.close();
  }

  /** A reader who takes nothing, and what becomes of his connection. */
  private static final class Stalled extends Socket {
    private final CountDownLatch closed = new CountDownLatch(1);

    OutputStream end() {
      return new OutputStream() {
        @Override
        public void write(int octet) throws IOException {
          try {
            closed.await();
          } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
          }
          throw new IOException("closed");
        }

        @Override
        public void write(byte[] bytes, int start, int length) throws IOException {
          write(0);
        }
      };
    }

    @Override
    public synchronized void close() {
      closed.countDown();
    }
  }

  @Test
  void whatIsReadArrivesInOrder() throws Exception {
    ByteArrayOutputStream reader = new ByteArrayOutputStream();
    try (Socket socket = new Socket()) {
      ReplyQueue queue = new ReplyQueue(socket, reader, room);
      for (int i = 0; i < 1000; i++) {
        queue.write(new byte[] {(byte) i, (byte) (i >> 8), 9}, 0, 2);
      }
      queue.finish();
      byte[] arrived = reader.toByteArray();
      assertThat(arrived).hasSize(2000);
      for (int i = 0; i < 1000; i++) {
        assertThat(arrived[2 * i]).isEqualTo((byte) i);
        assertThat(arrived[2 * i + 1]).isEqualTo((byte) (i >> 8));
      }
      assertThat(room.waiting()).isZero();
    }
  }

  @Test
  void whoDoesNotReadLosesHisConnectionOnlyWhenTheRoomIsNeeded() throws Exception {
    try (Stalled first = new Stalled();
        Stalled second = new Stalled()) {
      ReplyQueue early = new ReplyQueue(first, first.end(), room);
      ReplyQueue late = new ReplyQueue(second, second.end(), room);
      early.write(new byte[SIZE], 0, SIZE);
      late.write(new byte[SIZE], 0, SIZE);
      assertThat(room.waiting()).isEqualTo(2 * SIZE);
      late.write(new byte[1], 0, 1);
      assertThat(room.waiting()).isEqualTo(SIZE + 1);
      assertThatThrownBy(() -> early.write(1)).isInstanceOf(IOException.class);
    }
  }

  @Test
  void answersBecomeSmallerTheMoreAreBeingMade() throws Exception {
    long alone = room.share(SIZE, 100);
    Thread other = new Thread(() -> assertThat(room.share(SIZE, 100)).isLessThan(alone));
    other.start();
    other.join();
    ReplyMemory.made();
    assertThat(alone).isGreaterThan(100);
  }

  @Test
  void thereIsAlwaysTheLeast() {
    assertThat(new ReplyMemory(0).share(SIZE, 100)).isEqualTo(100);
    ReplyMemory.made();
  }

  @Test
  void answerThatWasSentGivesItsRoomBack() {
    long first = room.share(SIZE, 1);
    ReplyMemory.made();
    assertThat(room.share(SIZE, 1)).isEqualTo(first);
    ReplyMemory.made();
  }
}
