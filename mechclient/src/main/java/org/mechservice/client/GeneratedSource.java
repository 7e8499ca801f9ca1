package org.mechservice.client;

/**
 * A model class as readable Java.
 *
 * @param fileName name of the source file
 * @param text its text
 */
public record GeneratedSource(String fileName, String text) {}
