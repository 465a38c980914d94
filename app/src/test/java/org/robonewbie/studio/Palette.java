package org.robonewbie.studio;

import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Map.Entry;
import java.util.function.Function;
import java.util.function.IntUnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * Reduces a picture to 256 colours, which more than halves its file. Boxes of similar colours are cut into halves: those first that hold different
 * colours, or many pixels.
 */
final class Palette {

    private static final int SIZE = 256;
    private static final List<IntUnaryOperator> CHANNELS =
            List.of(colour -> (colour >> 16) & 0xff, colour -> (colour >> 8) & 0xff, colour -> colour & 0xff);

    private final BufferedImage image;
    private final List<Box> boxes = new ArrayList<>();

    Palette(BufferedImage image) {
        this.image = image;
        boxes.add(Box.of(List.copyOf(pixels().boxed()
                .collect(Collectors.groupingBy(Function.identity(), Collectors.counting()))
                .entrySet())));
        while (boxes.size() < SIZE) {
            Box worst =
                    boxes.stream().max(Comparator.comparingDouble(Box::error)).orElseThrow();
            if (worst.side == 0) {
                break;
            }
            boxes.remove(worst);
            boxes.addAll(worst.halves());
        }
    }

    private IntStream pixels() {
        int width = image.getWidth();
        return IntStream.of(image.getRGB(0, 0, width, image.getHeight(), null, 0, width));
    }

    /** Returns the picture with one byte for each pixel. */
    BufferedImage indexed() {
        int[] palette = boxes.stream().mapToInt(Box::mean).toArray();
        Map<Integer, Integer> indices = new HashMap<>();
        for (int i = 0; i < palette.length; i++) {
            for (Entry<Integer, Long> colour : boxes.get(i).colours) {
                indices.put(colour.getKey(), i);
            }
        }
        BufferedImage result = new BufferedImage(
                image.getWidth(),
                image.getHeight(),
                BufferedImage.TYPE_BYTE_INDEXED,
                new IndexColorModel(Byte.SIZE, palette.length, palette, 0, false, -1, 0));
        int[] samples = pixels().map(indices::get).toArray();
        result.getRaster().setPixels(0, 0, image.getWidth(), image.getHeight(), samples);
        return result;
    }

    /**
     * Similar colours, of which the palette has one.
     *
     * @param colours the colours and how many pixels have them
     * @param channel red, green or blue, in which they differ most
     * @param side how much they differ there
     */
    private record Box(List<Entry<Integer, Long>> colours, IntUnaryOperator channel, int side) {

        static Box of(List<Entry<Integer, Long>> colours) {
            return CHANNELS.stream()
                    .map(channel -> new Box(colours, channel, side(colours, channel)))
                    .max(Comparator.comparingInt(Box::side))
                    .orElseThrow();
        }

        private static int side(List<Entry<Integer, Long>> colours, IntUnaryOperator channel) {
            var values = colours.stream()
                    .mapToInt(colour -> channel.applyAsInt(colour.getKey()))
                    .summaryStatistics();
            return values.getMax() - values.getMin();
        }

        private long pixels() {
            return colours.stream().mapToLong(Entry::getValue).sum();
        }

        double error() {
            return side * Math.cbrt((double) pixels());
        }

        List<Box> halves() {
            int least = colours.stream()
                    .mapToInt(colour -> channel.applyAsInt(colour.getKey()))
                    .min()
                    .orElseThrow();
            return colours.stream()
                    .collect(
                            Collectors.partitioningBy(colour -> channel.applyAsInt(colour.getKey()) > least + side / 2))
                    .values()
                    .stream()
                    .map(Box::of)
                    .toList();
        }

        /** Returns the mean colour of the pixels. */
        int mean() {
            return CHANNELS.stream()
                    .mapToInt(each -> (int) Math.round((double) colours.stream()
                                    .mapToLong(colour -> each.applyAsInt(colour.getKey()) * colour.getValue())
                                    .sum()
                            / pixels()))
                    .reduce(0, (colour, value) -> (colour << 8) | value);
        }
    }
}
