package org.robonewbie.app.marking;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * What a program looks like when comments, layout, the names that its author has given, and numbers are taken away. Of the rest all runs
 * of a few words are compared, so that methods may change places (the idea is that of MOSS, Schleimer, Wilkerson and Aiken 2003).
 *
 * @param runs all runs of words that follow each other
 * @param numbers the numbers in their order
 */
record SourceShape(Set<String> runs, List<String> numbers) {

    /** How many words make a run: shorter ones are in each program, longer ones break at each change. */
    private static final int LENGTH = 9;

    private static final Pattern WORD = Pattern.compile("""
            (?<comment>//[^\\n]*|/\\*(?s:.*?)(?:\\*/|\\z))\
            |(?<text>\"""(?s:.*?)\"""|"(?:\\\\.|[^"\\\\\\n])*+"|'(?:\\\\.|[^'\\\\\\n])*+')\
            |(?<number>\\.?[0-9](?:[eE][-+]|[0-9a-zA-Z_.])*+)\
            |(?<name>[\\p{L}_$][\\p{L}\\p{N}_$]*)\
            |(?<sign>->|::|[-+*/%&|^=!<>]=|&&|\\|\\||\\+\\+|--|[^\\s])""");

    private static final Set<String> KEYWORDS = Set.of(
            "abstract",
            "assert",
            "break",
            "case",
            "catch",
            "class",
            "continue",
            "default",
            "do",
            "else",
            "enum",
            "extends",
            "final",
            "finally",
            "for",
            "if",
            "implements",
            "import",
            "instanceof",
            "interface",
            "new",
            "package",
            "private",
            "protected",
            "public",
            "return",
            "static",
            "super",
            "switch",
            "this",
            "throw",
            "throws",
            "try",
            "while");

    private static final Set<String> TYPE_HEADS = Set.of("class", "interface", "enum", "record");
    private static final Set<String> AFTER_A_DECLARED_NAME =
            Set.of("=", ";", ",", ")", "(", ":", "{", "extends", "implements");
    private static final Set<String> LINES_THAT_DO_NOT_COUNT = Set.of("import", "package");

    /** Takes copies. */
    SourceShape {
        runs = Collections.unmodifiableSet(new HashSet<>(runs));
        numbers = List.copyOf(numbers);
    }

    /** Reads a program; it need not be correct. */
    static SourceShape of(String source) {
        List<String> words = new ArrayList<>();
        List<String> numbers = new ArrayList<>();
        for (Matcher matcher = WORD.matcher(source); matcher.find(); ) {
            if (matcher.group("number") != null) {
                numbers.add(matcher.group());
                words.add("0");
            } else if (matcher.group("text") != null) {
                words.add("\"\"");
            } else if (matcher.group("comment") == null) {
                words.add(matcher.group());
            }
        }
        return new SourceShape(runs(plain(withoutImports(words))), numbers);
    }

    /** The share of the smaller program that is in the other one too, without what is in what everybody got; 0 to 1. */
    double similarityTo(SourceShape other, SourceShape given) {
        Set<String> own = new HashSet<>(runs);
        own.removeAll(given.runs);
        Set<String> others = new HashSet<>(other.runs);
        others.removeAll(given.runs);
        int smaller = Math.min(own.size(), others.size());
        own.retainAll(others);
        return smaller == 0 ? 0 : (double) own.size() / smaller;
    }

    /** How much of the program is not in what everybody got, in runs. */
    int ownRuns(SourceShape given) {
        return (int) runs.stream().filter(run -> !given.runs.contains(run)).count();
    }

    /** The share of numbers that both have, 0 to 1. */
    double sameNumbers(SourceShape other) {
        List<String> left = new ArrayList<>(other.numbers);
        long both = numbers.stream().filter(left::remove).count();
        int all = Math.max(numbers.size(), other.numbers.size());
        return all == 0 ? 1 : (double) both / all;
    }

    private static List<String> withoutImports(List<String> words) {
        List<String> rest = new ArrayList<>();
        boolean skipping = false;
        for (String word : words) {
            skipping |= LINES_THAT_DO_NOT_COUNT.contains(word);
            if (!skipping) {
                rest.add(word);
            }
            skipping &= !word.equals(";");
        }
        return rest;
    }

    /** Replaces the names that the author has given by one and the same; those of the framework stay. */
    private static List<String> plain(List<String> words) {
        Set<String> given = new HashSet<>();
        for (int i = 1; i < words.size() - 1; i++) {
            if (isName(words.get(i)) && declares(words.get(i - 1), words.get(i + 1))) {
                given.add(words.get(i));
            }
        }
        return words.stream().map(word -> given.contains(word) ? "x" : word).toList();
    }

    private static boolean declares(String before, String after) {
        boolean typeBefore = isName(before) || before.equals("]") || before.equals(">");
        return TYPE_HEADS.contains(before)
                || after.equals("->")
                || (typeBefore && AFTER_A_DECLARED_NAME.contains(after));
    }

    private static boolean isName(String word) {
        return Character.isJavaIdentifierStart(word.charAt(0)) && !KEYWORDS.contains(word);
    }

    private static Set<String> runs(List<String> words) {
        Set<String> runs = new HashSet<>();
        for (int i = 0; i + LENGTH <= words.size(); i++) {
            runs.add(String.join(" ", words.subList(i, i + LENGTH)));
        }
        return runs;
    }
}
