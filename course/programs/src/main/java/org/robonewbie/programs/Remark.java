package org.robonewbie.programs;

/**
 * A compiler diagnostic.
 *
 * @param from index of the first character to highlight
 * @param to index after the last character to highlight
 * @param line one-based line number; 0 if the diagnostic has no position in this file
 * @param serious whether the problem prevents the program from running
 * @param text the compiler's message
 * @param hint advice for beginners; empty if there is none
 */
public record Remark(int from, int to, int line, boolean serious, String text, String hint) {}
