package org.robonewbie.programs;

/**
 * What the compiler says about a place in a program.
 *
 * @param from index of the first character that is meant
 * @param to index after the last one
 * @param line number of its line, from 1; 0 if it has no place in this file
 * @param serious whether the program cannot run because of it
 * @param text the compiler's own words
 * @param hint what to do, in plain words; empty if there is nothing to add
 */
public record Remark(int from, int to, int line, boolean serious, String text, String hint) {}
