package org.robonewbie.exercises.marking;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Token n-grams of a program, ignoring comments, layout, numbers and the names chosen by its author. Comparing n-grams makes
 * the order of methods irrelevant, as in MOSS (Schleimer, Wilkerson and Aiken 2003).
 *
 * @param runs all n-grams
 * @param numbers the numbers in the order in which they occur
 */
record SourceShape(Set<String> runs, List<String> numbers) {

    /** Number of tokens in an n-gram. Shorter n-grams occur in every program; longer ones are broken by every change. */
    private static final int LENGTH = 9;

    /** Groups of {@link #WORD}; the web edition does not support named groups. */
    private static final int COMMENT = 1;

    private static final int TEXT = 2;
    private static final int NUMBER = 3;

    private static final Pattern WORD = Pattern.compile("""
            (//[^\\n]*|/\\*(?s:.*?)(?:\\*/|\\z))\
            |(\"""(?s:.*?)\"""|"(?:\\\\.|[^"\\\\\\n])*+"|'(?:\\\\.|[^'\\\\\\n])*+')\
            |(\\.?[0-9](?:[eE][-+]|[0-9a-zA-Z_.])*+)\
            |(\\p{javaJavaIdentifierStart}\\p{javaJavaIdentifierPart}*)\
            |(->|::|[-+*/%&|^=!<>]=|&&|\\|\\||\\+\\+|--|[^\\s])""");

    /**
     * Keywords and literals, without primitive types such as {@code int}: like class names, primitive types may precede
     * a declared name. The class {@code javax.lang.model.SourceVersion}, which lists keywords, is missing in the web
     * edition.
     */
    private static final Set<String> KEYWORDS = Set.of(
            ("abstract assert break case catch class const continue default do else enum extends final finally for goto if"
                            + " implements import instanceof interface native new package private protected public return"
                            + " static strictfp super switch synchronized this throw throws transient try volatile while _"
                            + " true false null")
                    .split(" "));

    private static final Set<String> TYPE_HEADS = Set.of("class", "interface", "enum", "record");
    private static final Set<String> AFTER_A_DECLARED_NAME =
            Set.of("=", ";", ",", ")", "(", ":", "{", "extends", "implements");
    private static final Set<String> IGNORED_STATEMENTS = Set.of("import", "package");

    /** Stores unmodifiable copies of the collections. */
    SourceShape {
        runs = Collections.unmodifiableSet(new HashSet<>(runs));
        numbers = List.copyOf(numbers);
    }

    /** Parses a program, which may have errors. */
    static SourceShape of(String source) {
        List<String> words = new ArrayList<>();
        List<String> numbers = new ArrayList<>();
        for (Matcher matcher = WORD.matcher(source); matcher.find(); ) {
            if (matcher.group(NUMBER) != null) {
                numbers.add(matcher.group());
                words.add("0");
            } else if (matcher.group(TEXT) != null) {
                words.add("\"\"");
            } else if (matcher.group(COMMENT) == null) {
                words.add(matcher.group());
            }
        }
        return new SourceShape(runs(plain(withoutImports(words))), numbers);
    }

    /**
     * Returns the share of the smaller program that also occurs in the larger one, 0 to 1. N-grams that occur in {@code
     * given}, such as the starter code, are ignored.
     */
    double similarityTo(SourceShape other, SourceShape given) {
        Set<String> own = new HashSet<>(runs);
        own.removeAll(given.runs);
        Set<String> others = new HashSet<>(other.runs);
        others.removeAll(given.runs);
        int smaller = Math.min(own.size(), others.size());
        own.retainAll(others);
        return smaller == 0 ? 0 : (double) own.size() / smaller;
    }

    /** Returns the number of n-grams that are not in {@code given}. */
    int ownRuns(SourceShape given) {
        return (int) runs.stream().filter(run -> !given.runs.contains(run)).count();
    }

    /** Returns the share of numbers that occur in both programs, 0 to 1. */
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
            skipping |= IGNORED_STATEMENTS.contains(word);
            if (!skipping) {
                rest.add(word);
            }
            skipping &= !word.equals(";");
        }
        return rest;
    }

    /** Replaces every name that the program declares with the same placeholder. Names from the framework are kept. */
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
        return Character.isJavaIdentifierStart(word.codePointAt(0)) && !KEYWORDS.contains(word);
    }

    private static Set<String> runs(List<String> words) {
        Set<String> runs = new HashSet<>();
        for (int i = 0; i + LENGTH <= words.size(); i++) {
            runs.add(String.join(" ", words.subList(i, i + LENGTH)));
        }
        return runs;
    }
}
