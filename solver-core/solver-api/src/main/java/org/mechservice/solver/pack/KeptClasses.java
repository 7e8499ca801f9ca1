package org.mechservice.solver.pack;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * Class files one after the other, as they are kept once they are unpacked: unpacking takes longer
 * than reading them again. The same classes give the same bytes, so that a hash told with the
 * packed classes shows whether what was kept is still what was unpacked.
 */
public final class KeptClasses {
  private KeptClasses() {}

  /**
   * Returns the form that is kept.
   *
   * @param classFiles class files by path; not modified
   */
  public static byte[] write(SortedMap<String, byte[]> classFiles) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (DataOutputStream out = new DataOutputStream(bytes)) {
      out.writeInt(classFiles.size());
      for (Map.Entry<String, byte[]> classFile : classFiles.entrySet()) {
        out.writeUTF(classFile.getKey());
        out.writeInt(classFile.getValue().length);
        out.write(classFile.getValue());
      }
    } catch (IOException e) {
      throw new IllegalStateException("bytes in memory can always be written", e);
    }
    return bytes.toByteArray();
  }

  /**
   * Returns the class files by path.
   *
   * @param kept what {@link #write} returned; not modified
   * @throws IOException if it is damaged
   */
  public static SortedMap<String, byte[]> read(byte[] kept) throws IOException {
    SortedMap<String, byte[]> classFiles = new TreeMap<>();
    try (DataInputStream in = new DataInputStream(new ByteArrayInputStream(kept))) {
      for (int count = in.readInt(); count > 0; count--) {
        String path = in.readUTF();
        int length = in.readInt();
        byte[] classFile = in.readNBytes(Math.max(0, length));
        if (classFile.length != length) {
          throw new IOException("the kept classes end too early");
        }
        classFiles.put(path, classFile);
      }
    }
    return classFiles;
  }
}
