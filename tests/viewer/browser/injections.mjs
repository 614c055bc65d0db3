// Texts that would harm a page that makes markup out of names and messages.
const kPayload = 'window.injected=1';

const kTemplates = [
  '<script>X</script>', '</script><script>X</script>', '<img src=x onerror=X>', '<svg onload=X>', '<svg><script>X</script></svg>', '<iframe srcdoc="<script>X</script>">',
  '<iframe src="javascript:X">', '<a href="javascript:X">a</a>', 'javascript:X', '<body onload=X>', '<input autofocus onfocus=X>', '<select autofocus onfocus=X>',
  '<textarea autofocus onfocus=X>', '<video><source onerror=X></video>', '<audio src=x onerror=X>', '<details open ontoggle=X>', '<marquee onstart=X>', '<object data="javascript:X">',
  '<embed src="javascript:X">', '<math href="javascript:X">a</math>', '<form action="javascript:X"><button>a</button></form>', '<link rel=stylesheet href="javascript:X">',
  '<base href="javascript:X//">', '<meta http-equiv="refresh" content="0;javascript:X">', '<style>@import "javascript:X";</style>', '<div style="background:url(javascript:X)">',
  '"><script>X</script>', "'><script>X</script>", '`><script>X</script>', '--><script>X</script>', ']]><script>X</script>', '</style><script>X</script>', '</title><script>X</script>',
  '</noscript><script>X</script>', '</textarea><script>X</script>', '<!--<script>X</script>-->', '<ScRiPt>X</sCrIpT>', '<script\n>X</script>', '<script/src="data:,X"></script>',
  '<<script>X//<</script>', '&lt;script&gt;X&lt;/script&gt;', '&#60;script&#62;X&#60;/script&#62;', '\\u003cscript\\u003eX\\u003c/script\\u003e', '%3Cscript%3EX%3C/script%3E',
  '${X}', '{{X}}', '{{constructor.constructor("X")()}}', '<%= X %>', '" onmouseover="X', "' onmouseover='X", '" autofocus onfocus="X', 'X;//', '";X;"', "';X;'", '\\";X;//',
  '<template><script>X</script></template>', '<slot onslotchange=X>', '<portal src="javascript:X">', '<dialog open onclose=X>', '<button popovertarget=x onclick=X>',
];

export const kInjections = [
  ...kTemplates.map((template) => template.replaceAll('X', kPayload)),
  '\u202Egnp.exe', '\u2066left\u2069', 'a\u0000b', '\u0007\u001b[31mred', '\uFEFF', '\u200b', '💥'.repeat(20), 'constructor', '__proto__', 'toString', 'NaN', 'W'.repeat(65536),
];

/** Bytes that are no UTF-8. */
export const kBrokenBytes = [Uint8Array.of(0xff, 0xfe, 0x3c, 0x62, 0x3e), Uint8Array.of(0xc3, 0x28), Uint8Array.of(0xed, 0xa0, 0x80)];
