package org.robonewbie.simulator.script;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.robonewbie.simulator.script.RubyToken.Kind;

/**
 * A statement of a Ruby script.
 *
 * @param tokens its tokens, at least one
 * @param block the enclosing block, such as {@code if} or {@code def}; empty if Ruby always executes the statement
 */
record RubyStatement(List<RubyToken> tokens, Optional<RubyToken> block) {

    private static final Set<String> OPENERS =
            Set.of("if", "unless", "while", "until", "case", "for", "begin", "def", "class", "module");
    private static final Set<String> MODIFIERS = Set.of("if", "unless", "while", "until");
    private static final Set<String> LOOPS = Set.of("while", "until", "for");
    private static final Set<String> WORDS_BEFORE_VALUES =
            Set.of("and", "or", "not", "then", "else", "elsif", "when", "in", "do", "ensure", "rescue");
    private static final Set<String> BRANCHES = Set.of("then", "else", "elsif", "when", "ensure", "rescue", "in");
    private static final Set<String> ENDS_OF_VALUES = Set.of(")", "]", "}");

    int line() {
        return tokens.get(0).line();
    }

    /** Splits a script into statements, including those inside blocks. */
    static List<RubyStatement> of(List<RubyToken> script) {
        return new Divider(script).statements();
    }

    private static final class Divider {

        private final List<RubyToken> script;
        private final List<RubyStatement> statements = new ArrayList<>();
        private final Deque<RubyToken> open = new ArrayDeque<>();
        private List<RubyToken> current = new ArrayList<>();
        private Optional<RubyToken> block = Optional.empty();
        private int brackets;
        private boolean inLoopHead;

        Divider(List<RubyToken> script) {
            this.script = script;
        }

        List<RubyStatement> statements() {
            for (int i = 0; i < script.size(); i++) {
                RubyToken token = script.get(i);
                if (token.kind() == Kind.SEPARATOR) {
                    if (!continues(token, i)) {
                        end();
                        inLoopHead = false;
                    }
                } else if (token.kind() == Kind.SIGN) {
                    sign(token);
                } else {
                    word(token, i);
                }
            }
            end();
            return statements;
        }

        /** Returns whether a statement continues on the next line. */
        private boolean continues(RubyToken separator, int index) {
            if (separator.text().equals(";")) {
                return false;
            }
            boolean inBrackets = brackets > 0;
            boolean openEnd = !current.isEmpty() && isOpenEnd(current.get(current.size() - 1));
            RubyToken next = index + 1 < script.size() ? script.get(index + 1) : separator;
            return inBrackets || openEnd || next.isSign(".") || next.isSign("&.");
        }

        private static boolean isOpenEnd(RubyToken last) {
            return (last.kind() == Kind.SIGN && !ENDS_OF_VALUES.contains(last.text()) && !last.isSign("|"))
                    || last.isWord("and")
                    || last.isWord("or")
                    || last.isWord("not");
        }

        private void sign(RubyToken token) {
            switch (token.text()) {
                case "(", "[" -> brackets++;
                case ")", "]" -> brackets = Math.max(0, brackets - 1);
                default -> {}
            }
            if (token.isSign("{") && brackets == 0) {
                current.add(token);
                open(token);
            } else if (token.isSign("}") && brackets == 0) {
                end();
                close();
            } else {
                add(token);
            }
        }

        private void word(RubyToken token, int index) {
            boolean isKeyword = token.kind() == Kind.WORD && !isName(index);
            if (isKeyword && OPENERS.contains(token.text()) && !isModifier(index) && !isShortDefinition(index)) {
                add(token);
                open.push(token);
                inLoopHead |= LOOPS.contains(token.text());
            } else if (isKeyword && token.text().equals("do") && inLoopHead) {
                inLoopHead = false;
                end();
            } else if (isKeyword && token.text().equals("do")) {
                add(token);
                open(token);
            } else if (isKeyword && token.text().equals("end")) {
                end();
                close();
            } else if (isKeyword && BRANCHES.contains(token.text()) && !inLoopHead) {
                end();
            } else {
                add(token);
            }
        }

        /**
         * Returns whether a word is a name even if it is spelled like a keyword: after a dot or {@code def}, or before
         * the colon of a hash key.
         */
        private boolean isName(int index) {
            RubyToken token = script.get(index);
            boolean behindDot = index > 0
                    && (script.get(index - 1).isSign(".")
                            || script.get(index - 1).isSign("&.")
                            || script.get(index - 1).isWord("def"));
            boolean label = index + 1 < script.size()
                    && script.get(index + 1).isSign(":")
                    && script.get(index + 1).from() == token.to();
            return behindDot || label;
        }

        /** Returns whether a keyword is a modifier, such as the {@code if} in {@code x = 1 if y}, which has no {@code end}. */
        private boolean isModifier(int index) {
            if (!MODIFIERS.contains(script.get(index).text()) || index == 0) {
                return false;
            }
            RubyToken last = script.get(index - 1);
            return switch (last.kind()) {
                case SEPARATOR -> false;
                case SIGN -> ENDS_OF_VALUES.contains(last.text());
                case WORD -> !WORDS_BEFORE_VALUES.contains(last.text()) || isName(index - 1);
                default -> true;
            };
        }

        /**
         * Returns whether a definition is endless, such as {@code def half(x) = x / 2}; in contrast, {@code def
         * x=(value)} has an {@code end}.
         */
        private boolean isShortDefinition(int index) {
            int name = index + 1;
            if (!script.get(index).isWord("def") || name >= script.size()) {
                return false;
            }
            while (name + 2 < script.size() && script.get(name + 1).isSign(".")) {
                name += 2;
            }
            int i = name + 1;
            boolean isSetter = i < script.size()
                    && script.get(i).isSign("=")
                    && script.get(i).from() == script.get(name).to();
            if (i < script.size() && script.get(i).isSign("(")) {
                while (i < script.size() && !script.get(i).isSign(")")) {
                    i++;
                }
                i++;
            }
            return !isSetter && i < script.size() && script.get(i).isSign("=");
        }

        private void open(RubyToken token) {
            open.push(token);
            end();
        }

        private void close() {
            if (!open.isEmpty()) {
                open.pop();
            }
        }

        private void add(RubyToken token) {
            if (current.isEmpty()) {
                block = Optional.ofNullable(open.peek());
            }
            current.add(token);
        }

        private void end() {
            if (!current.isEmpty()) {
                statements.add(new RubyStatement(List.copyOf(current), block));
                current = new ArrayList<>();
            }
        }
    }
}
