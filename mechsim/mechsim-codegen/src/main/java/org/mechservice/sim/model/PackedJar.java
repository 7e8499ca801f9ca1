package org.mechservice.sim.model;

import java.util.Map;

/**
 * A JAR in memory. The same input gives the same bytes.
 *
 * @param fileName suggested file name
 * @param bytes the file; not to be modified
 * @param sha256 its SHA-256, lower-case hexadecimal
 * @param mainClass the class to start, or the model class if there is none to start
 * @param modelBytes compressed size of the model's own classes
 * @param manifest main attributes of the manifest, in order
 */
@SuppressWarnings(
    "ArrayRecordComponent") // a file's bytes, megabytes at times: handed on, never changed
public record PackedJar(
    String fileName,
    byte[] bytes,
    String sha256,
    String mainClass,
    long modelBytes,
    Map<String, String> manifest) {}
