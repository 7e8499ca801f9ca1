package org.mechservice.sim.jar;

import java.util.Arrays;
import java.util.zip.Deflater;

/** How the entries of a JAR are made small. */
public enum Packing {
  /** By the virtual machine's own routine: for JARs that run at once, on this machine. */
  QUICK {
    @Override
    public byte[] deflated(byte[] content) {
      Deflater deflater = new Deflater(Deflater.BEST_COMPRESSION, true);
      try {
        deflater.setInput(content);
        deflater.finish();
        // Never as long: what cannot be made smaller is stored, five bytes for each 16 KB.
        byte[] buffer = new byte[content.length + content.length / 1000 + 64];
        int size = deflater.deflate(buffer);
        return Arrays.copyOf(buffer, size);
      } finally {
        deflater.end();
      }
    }
  },

  /** As far as it goes, the same on every machine: for JARs that are kept. */
  SMALLEST {
    @Override
    public byte[] deflated(byte[] content) {
      return Deflation.of(content);
    }
  };

  /** Returns a file as it stands in the JAR. */
  public abstract byte[] deflated(byte[] content);
}
