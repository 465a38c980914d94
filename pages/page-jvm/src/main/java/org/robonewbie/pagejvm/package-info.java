/**
 * Bytecode interpreter for class files that the page has compiled from a student's program and that call the compiled classes of the
 * framework. Start with {@link org.robonewbie.pagejvm.Machine}, then {@link org.robonewbie.pagejvm.Members}. Instructions: Java Virtual
 * Machine Specification, chapter 6.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.pagejvm;
