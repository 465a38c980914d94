package org.robonewbie.programs.completion;

/**
 * A completion proposal.
 *
 * @param label text in the list, such as {@code setJointSpeed}
 * @param detail additional text, such as parameters and type
 * @param kind {@code method}, {@code property}, {@code constant}, {@code class} or {@code variable}
 * @param insert text to insert; the editor closes a trailing open parenthesis
 * @param documentation plain text; empty if there is none
 */
public record Proposal(String label, String detail, String kind, String insert, String documentation) {}
