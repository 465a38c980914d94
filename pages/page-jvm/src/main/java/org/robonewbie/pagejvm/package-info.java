/**
 * Runs class files that the page has compiled from a student's program, instruction by instruction, among the classes of the framework
 * that are compiled already. Read {@link org.robonewbie.pagejvm.Machine} first, then {@link
 * org.robonewbie.pagejvm.Members}; the instructions are those of the Java Virtual Machine Specification, chapter 6.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.pagejvm;
