package org.mechservice.orb.connection;

import org.jacorb.config.Configuration;
import org.jacorb.orb.BufferManager;
import org.jacorb.orb.BufferManagerFactory;
import org.jacorb.orb.IBufferManager;
import org.omg.CORBA.NO_MEMORY;

/**
 * Refuses messages above a size before memory for them is taken: the ORB trusts the length in a
 * message's header, and has no limit of its own. Outgoing messages are held to the same size.
 *
 * <p>Made by the ORB from its properties, hence public.
 */
public final class LimitedBuffers implements BufferManagerFactory {
  /**
   * Largest message. A model file of the largest size with its user files, and the largest result
   * block, fit.
   */
  public static final int MAX_MESSAGE_BYTES = 32 << 20;

  private static final int LARGEST_KEPT_BYTES = 1 << 16;

  @Override
  public IBufferManager newSingletonBufferManager(Configuration configuration) {
    return new Limited(configuration);
  }

  @Override
  public IBufferManager newBufferManager(IBufferManager singleton, Configuration configuration) {
    return new Limited(configuration);
  }

  private static final class Limited extends BufferManager {
    Limited(Configuration configuration) {
      super(configuration);
    }

    @Override
    public byte[] getBuffer(int size) {
      requireAllowed(size);
      return size > LARGEST_KEPT_BYTES ? new byte[size] : super.getBuffer(size);
    }

    @Override
    public byte[] getExpandedBuffer(int size) {
      requireAllowed(size);
      return getBuffer(Math.min(2 * size, MAX_MESSAGE_BYTES));
    }

    /** The ORB keeps used buffers by the dozen, for each size; of large ones that is too many. */
    @Override
    public void returnBuffer(byte[] buffer, boolean grown) {
      if (buffer.length <= LARGEST_KEPT_BYTES) {
        super.returnBuffer(buffer, grown);
      }
    }

    private static void requireAllowed(int size) {
      if (size > MAX_MESSAGE_BYTES) {
        throw new NO_MEMORY(
            "message of " + size + " bytes; at most " + MAX_MESSAGE_BYTES + " are allowed");
      }
    }
  }
}
