package org.robonewbie.programs.completion;

/**
 * Something that could be written at a place in a program.
 *
 * @param label what is listed, such as {@code setJointSpeed}
 * @param detail what belongs to it, such as its parameters and type
 * @param kind {@code method}, {@code property}, {@code constant}, {@code class} or {@code variable}
 * @param insert what is written; an open parenthesis at its end is to be closed behind the parameters
 * @param documentation what it does; empty if nothing is known
 */
public record Proposal(String label, String detail, String kind, String insert, String documentation) {}
