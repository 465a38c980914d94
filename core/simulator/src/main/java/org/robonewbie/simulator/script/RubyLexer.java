package org.robonewbie.simulator.script;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.OptionalInt;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robonewbie.simulator.script.RubyToken.Kind;

/**
 * Tokenizer for the subset of Ruby that start scripts use. Comments, {@code =begin}, {@code __END__}, strings and
 * here-documents are recognised, so that their contents are never mistaken for code.
 */
final class RubyLexer {

    private static final Pattern BLANK = Pattern.compile("(?:[ \\t\\f\\x0B]|\\\\\\n)+");
    private static final Pattern BLOCK_COMMENT =
            Pattern.compile("=begin(?:\\s[^\\n]*)?\\n(?s:.*?)(?:^=end\\b[^\\n]*|\\z)", Pattern.MULTILINE);
    private static final Pattern DOCUMENT_END = Pattern.compile("__END__(?:\\n|\\z)");
    private static final Pattern HERE_DOCUMENT = Pattern.compile("<<([~-]?)(['\"`]?)([A-Za-z_]\\w*)\\2");
    private static final Pattern NUMBER = Pattern.compile(
            "0[xX][\\da-fA-F_]+|0[bB][01_]+|0[oO][0-7_]+|\\d[\\d_]*(?:\\.\\d[\\d_]*)?(?:[eE][-+]?\\d[\\d_]*)?");
    private static final Pattern WORD = Pattern.compile("(?:@@?)?[\\p{L}_][\\p{L}\\p{N}_]*(?:[?!](?!=))?");
    private static final Pattern GLOBAL = Pattern.compile("\\$(?:[\\p{L}_][\\p{L}\\p{N}_]*|\\d+|-\\w|[^\\s\\w])");
    private static final Pattern SYMBOL = Pattern.compile(":([\\p{L}_][\\p{L}\\p{N}_]*[?!=]?(?![=>~]))");
    private static final Pattern PERCENT = Pattern.compile("%([qQwWiIrsx]?)([^\\w\\s])");
    private static final Pattern SIGN = Pattern.compile(
            "\\*\\*=|<=>|===|\\.\\.\\.|<<=|>>=|&&=|\\|\\|=|\\*\\*|==|!=|>=|<=|&&|\\|\\||\\+=|-=|\\*=|/=|%=|\\|=|&=|=~|!~|=>|->|::|\\.\\.|<<|>>|&\\.|.",
            Pattern.DOTALL);
    private static final Set<String> VALUES_END = Set.of(")", "]", "}");
    private static final Set<String> BEFORE_EXPRESSION = Set.of(
            "if", "unless", "while", "until", "and", "or", "not", "then", "else", "elsif", "when", "in", "do", "return",
            "case", "puts", "print", "raise", "begin", "yield");
    private static final String OPENING = "([{<";
    private static final String CLOSING = ")]}>";

    private final String text;
    private final List<RubyToken> tokens = new ArrayList<>();
    /** Names of assigned variables. Unlike a call, a variable is followed by an operator, not by an argument. */
    private final Set<String> variables = new HashSet<>();

    private final Deque<Matcher> documents = new ArrayDeque<>();
    private int at;
    private int line = 1;
    private OptionalInt unfinished = OptionalInt.empty();

    private RubyLexer(String text) {
        this.text = text;
    }

    /**
     * The tokens of a script.
     *
     * @param all all tokens in script order
     * @param unfinishedLine line of an unterminated string at which the tokenizer stopped; empty if there is none
     */
    record Result(List<RubyToken> all, OptionalInt unfinishedLine) {}

    /** Tokenizes a script. */
    static Result read(String script) {
        RubyLexer lexer = new RubyLexer(script.replaceAll("\\R", "\n"));
        lexer.read();
        return new Result(lexer.tokens, lexer.unfinished);
    }

    private void read() {
        while (at < text.length() && unfinished.isEmpty()) {
            if (isAtLineStart() && here(DOCUMENT_END).lookingAt()) {
                break;
            }
            boolean comment = isAtLineStart() && skipped(BLOCK_COMMENT);
            if (!comment && !skipped(BLANK)) {
                next();
            }
        }
        add(Kind.SEPARATOR, "\n", at);
    }

    private void next() {
        char sign = text.charAt(at);
        if (sign == '#') {
            int end = text.indexOf('\n', at);
            at = end < 0 ? text.length() : end;
        } else if (sign == '\n' || sign == ';') {
            add(Kind.SEPARATOR, String.valueOf(sign), at + 1);
            if (sign == '\n') {
                skipDocuments();
            }
        } else if (sign == '\'' || sign == '"' || sign == '`') {
            string(at + 1, sign, sign, sign == '\'' ? Kind.STRING : sign == '"' ? Kind.STRING : Kind.OTHER_STRING);
        } else if (!hereDocument() && !percentString() && !regularExpression()) {
            word();
        }
    }

    private void word() {
        if (!(token(NUMBER, Kind.NUMBER, 0) || token(WORD, Kind.WORD, 0) || token(GLOBAL, Kind.GLOBAL, 0))
                && !(isExpressionStart() && token(SYMBOL, Kind.STRING, 1))) {
            token(SIGN, Kind.SIGN, 0);
        }
    }

    private boolean token(Pattern pattern, Kind kind, int group) {
        Matcher matcher = here(pattern);
        if (!matcher.lookingAt()) {
            return false;
        }
        add(kind, matcher.group(group), matcher.end());
        return true;
    }

    private boolean hereDocument() {
        Matcher matcher = here(HERE_DOCUMENT);
        if (!matcher.lookingAt() || !isExpressionStart()) {
            return false;
        }
        documents.add(matcher);
        add(Kind.OTHER_STRING, matcher.group(), matcher.end());
        return true;
    }

    /** Skips the bodies of the here-documents that started on the line just read. */
    private void skipDocuments() {
        while (!documents.isEmpty()) {
            Matcher document = documents.remove();
            String indent = document.group(1).isEmpty() ? "" : "[ \\t]*";
            Matcher end = Pattern.compile("^" + indent + document.group(3) + "$", Pattern.MULTILINE)
                    .matcher(text);
            boolean found = end.find(at);
            unfinished = found ? unfinished : OptionalInt.of(line);
            moveTo(found ? Math.min(text.length(), end.end() + 1) : text.length());
        }
    }

    private boolean percentString() {
        Matcher matcher = here(PERCENT);
        if (!matcher.lookingAt() || !isExpressionStart()) {
            return false;
        }
        char open = matcher.group(2).charAt(0);
        int pair = OPENING.indexOf(open);
        boolean plain = matcher.group(1).equals("q")
                || matcher.group(1).equals("Q")
                || matcher.group(1).isEmpty();
        string(matcher.end(), open, pair < 0 ? open : CLOSING.charAt(pair), plain ? Kind.STRING : Kind.OTHER_STRING);
        return true;
    }

    private boolean regularExpression() {
        if (text.charAt(at) != '/' || !isExpressionStart()) {
            return false;
        }
        string(at + 1, '/', '/', Kind.OTHER_STRING);
        return true;
    }

    private void string(int begin, char open, char close, Kind usual) {
        StringBuilder content = new StringBuilder();
        int depth = 0;
        int i = begin;
        Kind kind = usual;
        while (i < text.length() && (depth > 0 || text.charAt(i) != close)) {
            char sign = text.charAt(i);
            depth += open == close ? 0 : sign == open ? 1 : sign == close ? -1 : 0;
            if (sign == '\\' && i + 1 < text.length()) {
                i++;
                boolean known = text.charAt(i) == close || text.charAt(i) == '\\';
                content.append(known || open != '\'' ? "" : "\\");
                kind = known || open == '\'' ? kind : Kind.OTHER_STRING;
            } else if (sign == '#' && open != '\'' && i + 1 < text.length() && "{$@".indexOf(text.charAt(i + 1)) >= 0) {
                kind = Kind.OTHER_STRING;
            }
            content.append(text.charAt(i));
            i++;
        }
        if (i == text.length()) {
            unfinished = OptionalInt.of(line);
        }
        add(kind, content.toString(), Math.min(text.length(), i + 1));
    }

    /**
     * Returns whether a value may start at the current character: after an operator, or after a word and a space, as in
     * {@code puts /x/}.
     */
    private boolean isExpressionStart() {
        if (tokens.isEmpty()) {
            return true;
        }
        RubyToken last = tokens.get(tokens.size() - 1);
        return switch (last.kind()) {
            case SEPARATOR -> true;
            case SIGN -> !VALUES_END.contains(last.text());
            case WORD -> BEFORE_EXPRESSION.contains(last.text()) || isCall(last);
            default -> false;
        };
    }

    /**
     * Returns whether a word is a call whose argument starts at the current character, which has a space before it but
     * none after it, as in {@code puts /x/}.
     */
    private boolean isCall(RubyToken word) {
        boolean blankBehind = at + 1 >= text.length() || Character.isWhitespace(text.charAt(at + 1));
        return word.to() < at && !blankBehind && !variables.contains(word.text());
    }

    private boolean skipped(Pattern pattern) {
        Matcher matcher = here(pattern);
        boolean found = matcher.lookingAt();
        if (found) {
            moveTo(matcher.end());
        }
        return found;
    }

    private boolean isAtLineStart() {
        return at == 0 || text.charAt(at - 1) == '\n';
    }

    private Matcher here(Pattern pattern) {
        return pattern.matcher(text)
                .region(at, text.length())
                .useAnchoringBounds(false)
                .useTransparentBounds(true);
    }

    private void add(Kind kind, String content, int to) {
        if (kind == Kind.SIGN && content.equals("=") && !tokens.isEmpty()) {
            variables.add(tokens.get(tokens.size() - 1).text());
        }
        tokens.add(new RubyToken(kind, content, line, at, to));
        moveTo(to);
    }

    private void moveTo(int place) {
        for (int i = at; i < place; i++) {
            line += text.charAt(i) == '\n' ? 1 : 0;
        }
        at = place;
    }
}
