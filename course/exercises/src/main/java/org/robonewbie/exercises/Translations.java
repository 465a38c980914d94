package org.robonewbie.exercises;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * Dictionary of phrases. A phrase may contain placeholders {@code %s}, whose values are translated too. Text without an
 * entry is split at commas, semicolons and colons, and its parts are translated.
 */
final class Translations {

    private static final String GAP = "%s";
    private static final Pattern CLAUSE = Pattern.compile("(.+?)([,;:] |$)", Pattern.DOTALL);

    private final Map<String, String> phrases;
    private final List<Phrase> withGaps;

    private Translations(Map<String, String> phrases) {
        this.phrases = Collections.unmodifiableMap(new HashMap<>(phrases));
        withGaps = phrases.entrySet().stream()
                .filter(pair -> pair.getKey().contains(GAP))
                .map(pair -> Phrase.of(pair.getKey(), pair.getValue()))
                .sorted(Comparator.comparing((Phrase phrase) -> -phrase.length)
                        .thenComparing(phrase -> phrase.translation))
                .toList();
    }

    private record Phrase(Pattern pattern, String translation, int length) {

        static Phrase of(String sentence, String translation) {
            String[] texts = sentence.split(GAP, -1);
            String pattern = List.of(texts).stream().map(Pattern::quote).collect(Collectors.joining("(.+?)"));
            String format = translation.replaceAll("%(?![s\\d])", "%%");
            return new Phrase(Pattern.compile(pattern), format, sentence.length() - GAP.length() * (texts.length - 1));
        }
    }

    /** {@return an empty dictionary} */
    static Translations empty() {
        return new Translations(Map.of());
    }

    /**
     * Loads a dictionary, in which each phrase is followed by its translation on the next line.
     *
     * @param files paths of resource files
     * @return the dictionary
     */
    static Translations read(String... files) {
        Map<String, String> pairs = new HashMap<>();
        for (String file : files) {
            for (String pair : text(file).replace("\r", "").strip().split("\n\n+", -1)) {
                String[] lines = pair.split("\n", -1);
                pairs.put(lines[0], lines[1]);
            }
        }
        return new Translations(pairs);
    }

    private static String text(String file) {
        try (InputStream stream =
                Objects.requireNonNull(Translations.class.getResourceAsStream(file), "There is no file " + file)) {
            return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException unreadable) {
            throw new UncheckedIOException("The file " + file + " cannot be read.", unreadable);
        }
    }

    /** {@return all phrases with their translations} */
    Map<String, String> phrases() {
        return phrases;
    }

    /**
     * Translates text.
     *
     * @param text the text
     * @return its translation; parts without an entry are unchanged
     */
    String translated(String text) {
        return phrase(text).orElseGet(() -> clauses(text));
    }

    private String clauses(String text) {
        StringBuilder translated = new StringBuilder();
        int count = 0;
        for (Matcher clause = CLAUSE.matcher(text); clause.find(); count++) {
            translated.append(phrase(clause.group(1)).orElse(clause.group(1))).append(clause.group(2));
        }
        return count < 2 ? text : translated.toString();
    }

    private Optional<String> phrase(String text) {
        String known = phrases.get(text);
        if (known != null) {
            return Optional.of(known);
        }
        return withGaps.stream()
                .map(phrase -> filled(phrase, phrase.pattern.matcher(text)))
                .flatMap(Optional::stream)
                .findFirst();
    }

    private Optional<String> filled(Phrase phrase, Matcher matcher) {
        if (!matcher.matches()) {
            return Optional.empty();
        }
        List<Object> words = new ArrayList<>();
        for (int gap = 1; gap <= matcher.groupCount(); gap++) {
            words.add(translated(matcher.group(gap)));
        }
        return Optional.of(String.format(phrase.translation, words.toArray()));
    }
}
