# Fonts that are shipped where the system may not have them.
set(BRAITENLAB_FONTS
  /usr/share/fonts/truetype/noto/NotoSans-Regular.ttf /usr/share/fonts/truetype/noto/NotoSans-Bold.ttf
  /usr/share/fonts/truetype/noto/NotoSansMono-Regular.ttf /usr/share/fonts/truetype/noto/NotoSansMath-Regular.ttf
  /usr/share/fonts/truetype/noto/NotoSansSymbols2-Regular.ttf
  /usr/share/fonts/truetype/fork-awesome/forkawesome-webfont.ttf)
