package org.robonewbie.protocol.monitor;

/**
 * A light; its position is that of the transform around it.
 *
 * @param diffuse colour of the light that comes from the light's direction
 * @param ambient colour of the light that comes from everywhere
 * @param specular colour of highlights
 */
public record LightNode(Colour diffuse, Colour ambient, Colour specular) implements SceneNode {

    /**
     * A colour.
     *
     * @param red from 0 to 1
     * @param green from 0 to 1
     * @param blue from 0 to 1
     * @param alpha opacity from 0 to 1
     */
    public record Colour(float red, float green, float blue, float alpha) {

        /**
         * Creates a grey.
         *
         * @param brightness from 0 to 1
         * @return the opaque grey
         */
        public static Colour grey(float brightness) {
            return new Colour(brightness, brightness, brightness, 1);
        }
    }
}
