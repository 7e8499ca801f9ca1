package org.mechservice.guard.worker;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * The model that a worker has.
 *
 * @param className the model's class
 * @param classFiles the model's own class files, by binary name
 * @param userClassFiles those of its users
 */
public record WorkerModel(
    String className,
    SortedMap<String, byte[]> classFiles,
    SortedMap<String, byte[]> userClassFiles) {

  void write(DataOutputStream out) throws IOException {
    out.writeUTF(className);
    writeFiles(out, classFiles);
    writeFiles(out, userClassFiles);
  }

  static WorkerModel read(DataInputStream in) throws IOException {
    String className = in.readUTF();
    SortedMap<String, byte[]> classFiles = readFiles(in);
    return new WorkerModel(className, classFiles, readFiles(in));
  }

  private static void writeFiles(DataOutputStream out, Map<String, byte[]> files)
      throws IOException {
    out.writeInt(files.size());
    for (Map.Entry<String, byte[]> file : files.entrySet()) {
      byte[] name = file.getKey().getBytes(StandardCharsets.UTF_8);
      out.writeInt(name.length);
      out.write(name);
      out.writeInt(file.getValue().length);
      out.write(file.getValue());
    }
  }

  private static SortedMap<String, byte[]> readFiles(DataInputStream in) throws IOException {
    SortedMap<String, byte[]> files = new TreeMap<>();
    for (int left = in.readInt(); left > 0; left--) {
      String name = new String(in.readNBytes(in.readInt()), StandardCharsets.UTF_8);
      files.put(name, in.readNBytes(in.readInt()));
    }
    return files;
  }
}
