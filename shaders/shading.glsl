uniform int shading;  // a Shading of core/view/view_settings.h
const int smooth_shading = 1;
