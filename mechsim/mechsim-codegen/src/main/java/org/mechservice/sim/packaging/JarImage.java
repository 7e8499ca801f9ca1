package org.mechservice.sim.packaging;

import java.util.Map;

/**
 * A JAR in memory. The same input gives the same bytes.
 *
 * @param fileName suggested file name
 * @param bytes the file; must not be modified
 * @param sha256 its SHA-256, lower-case hexadecimal
 * @param mainClass the class to start, or the model class of a JAR without a solver
 * @param modelBytes compressed size of the model's own classes
 * @param manifest main attributes of the manifest, in order
 */
@SuppressWarnings("ArrayRecordComponent") // a file of up to megabytes; never changed
public record JarImage(
    String fileName,
    byte[] bytes,
    String sha256,
    String mainClass,
    long modelBytes,
    Map<String, String> manifest) {}
